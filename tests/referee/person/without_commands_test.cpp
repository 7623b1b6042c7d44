// A game that nobody commands: play is on throughout, and AutoRef only reports its calls.
#include <gtest/gtest.h>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

Configuration commanded_by_nobody() {
  Configuration configuration;
  configuration.control = Control::kNone;
  return configuration;
}

TEST(WithoutCommands, PlayIsOnFromTheFirstFrame) {
  ScriptedGame game(commanded_by_nobody());
  game.line_up();
  game.step();
  EXPECT_EQ(game.referee.state(), State::kRun);
  EXPECT_TRUE(game.referee.is_ball_in_play());
}

TEST(WithoutCommands, CallsAreReportedOnceAndPlayStaysOn) {
  ScriptedGame game(commanded_by_nobody());
  game.placement_works = false;
  game.line_up().run(0.1);
  game.kick_from(Side::kWest, 1, {0.5, 1.2}, {0, 3});
  const Decision call = game.run_until("throw_in", 2);
  EXPECT_EQ(call.to, State::kRun);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
  game.ball_mps = Vec2(0, 0);
  game.run(30);
  EXPECT_EQ(game.count("throw_in"), 1);
  game.put_ball({0.5, -1});
  game.run(2);
  game.kick_from(Side::kEast, 1, {0.5, -1.2}, {0, -3});
  EXPECT_EQ(game.run_until("throw_in", 2).restart(),
            (Command{CommandKind::kIndirectFree, Side::kWest}));
}

}  // namespace
}  // namespace autoref::referee
