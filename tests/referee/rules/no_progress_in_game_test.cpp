// "Both teams can manipulate, no progress": 10 s in Division B, 5 s in Division A (2026).
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

double seconds_to_no_progress(std::string_view book) {
  ScriptedGame game(by_book(book));
  game.line_up().kick_off();
  game.put_ball({0.4, 0.2});
  const double since_s = game.now_s();
  return game.run_until("no_progress_in_game").time_s - since_s;
}

TEST(NoProgress, IsAForceStartAfterTenSecondsInDivisionB) {
  EXPECT_NEAR(seconds_to_no_progress("2026-b"), 10, 0.05);
}

TEST(NoProgress, IsAForceStartAfterFiveSecondsInDivisionA) {
  EXPECT_NEAR(seconds_to_no_progress("2026-a"), 5, 0.05);
}

TEST(NoProgress, RestartsOneMetreFromTheAreas) {
  ScriptedGame game(by_book("2026-b"));
  game.line_up().kick_off();
  game.put_ball({3.3, 0.2});  // 0.2 m in front of the area
  game.run_until("no_progress_in_game");
  EXPECT_EQ(game.signal.next_command->kind, CommandKind::kForceStart);
  const Vec2& position_m = game.signal.placement->target_m;
  EXPECT_NEAR(distance_to_defence_area(by_book("2026-b").field, Side::kEast, position_m), 1, 1e-9);
}

TEST(NoProgress, IsNotCalledWhileTheBallMoves) {
  ScriptedGame game(by_book("2026-b"));
  game.line_up().kick_off();
  game.put_ball({-0.8, 2.0});
  game.ball_mps = {0.06, 0};  // 600 mm in 10 s
  game.run(20);
  EXPECT_EQ(game.count("no_progress_in_game"), 0);
}

TEST(NoProgress, IsNotCalledInAnArea) {
  ScriptedGame game(by_book("2026-b"));
  game.line_up().kick_off();
  game.put_ball({4.0, 0.2});
  game.run(15);
  EXPECT_EQ(game.count("no_progress_in_game"), 0);
}

TEST(NoProgress, IsNotARuleOfThePaper) {
  ScriptedGame game = in_play();
  EXPECT_NO_THROW(game.run_until("stuck_ball", 11));
  EXPECT_EQ(game.count("no_progress_in_game"), 0);
}

}  // namespace
}  // namespace autoref::referee
