// The force start of the paper and the Laws is tested with the machine's transitions. This file
// tests the 2026 rules, which give the opponents a free kick.
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

TEST(RestartNotTaken, In2026GivesTheOpponentsAFreeKickFromThere) {
  ScriptedGame game = throw_in_game(by_book("2026-b"));
  const Vec2 ball_m = game.frame.ball->position_m;
  const double since_s = game.now_s();
  const Decision untaken = game.run_until("restart_not_taken");
  EXPECT_NEAR(untaken.time_s - since_s, 10, 1e-6);
  EXPECT_EQ(untaken.restart(), (Command{CommandKind::kDirectFree, Side::kWest}));
  EXPECT_NEAR((game.signal.placement->target_m - ball_m).norm(), 0, 1e-9);
}

TEST(RestartNotTaken, InDivisionAFreeKicksHaveFiveSecondsAndKickOffsTen) {
  ScriptedGame game = throw_in_game(by_book("2026-a"));
  double since_s = game.now_s();
  EXPECT_NEAR(game.run_until("restart_not_taken").time_s - since_s, 5, 1e-6);
  ScriptedGame other(by_book("2026-a"));
  other.line_up().kick_off();
  since_s = other.now_s();
  const Decision untaken = other.run_until("restart_not_taken");
  EXPECT_NEAR(untaken.time_s - since_s, 10, 1e-6);
  EXPECT_EQ(untaken.restart(), (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_EQ(other.signal.placement->target_m, Vec2(0, 0));
}

TEST(RestartNotTaken, ByTheLawsLeadsToANeutralRestart) {
  ScriptedGame game = throw_in_game(by_book("2014"));
  EXPECT_EQ(game.run_until("restart_not_taken").restart()->kind, CommandKind::kForceStart);
}

}  // namespace
}  // namespace autoref::referee
