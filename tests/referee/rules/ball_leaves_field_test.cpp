// Balls that leave the field, under rule books other than the paper's.
#include <gtest/gtest.h>

#include "tests/referee/support/booked_game.hpp"

namespace autoref::referee {
namespace {

TEST(BallLeavesField, OverATouchLineIsADirectFreeKickIn2026) {
  const ScriptedGame game = stopped_game(by_book("2026-b"));
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(0.4, 2.8)).norm(), 0, 1e-9);
  EXPECT_EQ(game.decisions.back().finding.rule, "2026, Ball Leaves The Field");
}

TEST(BallLeavesField, OverATouchLineIsAnIndirectFreeKickByTheLaws) {
  const ScriptedGame game = stopped_game(by_book("2014"));
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kIndirectFree, Side::kEast}));
}

// Deviation D14
void expect_force_start_after_unknown_touch(const Configuration& configuration) {
  ScriptedGame game = in_play(configuration);
  game.put_ball({configuration.field.half_length_m() - 0.2, -1.0});
  game.ball_mps = {4, 0};
  game.run_until("goal_line_unknown", 2);
  EXPECT_EQ(game.signal.next_command->kind, CommandKind::kForceStart);
  const Vec2& position_m = game.signal.placement->target_m;
  EXPECT_GE(distance_to_defence_area(configuration.field, Side::kEast, position_m),
            configuration.rules.neutral_to_area_m - 1e-9);
}

TEST(BallLeavesField, OverAGoalLineAfterAnUnknownTouchIsAForceStart) {
  expect_force_start_after_unknown_touch(by_book("2014"));
  expect_force_start_after_unknown_touch(by_book("2026-b"));
}

}  // namespace
}  // namespace autoref::referee
