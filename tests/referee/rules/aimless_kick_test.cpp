#include <gtest/gtest.h>
#include "referee/rules/rule.hpp"

#include "tests/referee/rules/rule_scene.hpp"

namespace autoref::referee {
namespace {

// Play after a second robot's touch, so that the ball no longer comes straight from the kick-off.
ScriptedGame after_a_touch(const Configuration& configuration) {
  ScriptedGame game = in_play(configuration);
  game.kick_from(Side::kEast, 5, {0, 1}, {0, 1});
  game.run(0.3);
  return game;
}

ScriptedGame long_kick(const Configuration& configuration, const Vec2& from_m) {
  ScriptedGame game = after_a_touch(configuration);
  game.kick_from(Side::kWest, 1, from_m, {6, 0});
  return game;
}

TEST(AimlessKick, FromTheOwnHalfIsAFreeKickFromWhereItWasKicked) {
  ScriptedGame game = long_kick(by_book("2026-b"), {-0.001, 2});
  const Decision call = game.run_until("aimless_kick", 1);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_LE((game.signal.placement->target_m - Vec2(0, 2)).norm(), 0.002);
  EXPECT_LE((*call.finding.details.ball_m - Vec2(4.5 + kBallRadius_m, 2)).norm(), 0.025);
}

TEST(AimlessKick, FromTheOpponentsHalfIsAGoalKick) {
  ScriptedGame game = long_kick(by_book("2026-b"), {0.001, 2});
  EXPECT_TRUE(is_called(game, "goal_kick"));
}

TEST(AimlessKick, IsNotCalledIfAnotherRobotTouchesTheBall) {
  ScriptedGame game = long_kick(by_book("2026-b"), {-1, 2});
  game.run(0.3);
  game.ball_mps = Vec2(0, 0);
  game.kick(Side::kWest, 2, {6, 0});
  EXPECT_TRUE(is_called(game, "goal_kick"));
}

TEST(AimlessKick, OverTheOwnGoalLineIsACornerKick) {
  ScriptedGame game = after_a_touch(by_book("2026-b"));
  game.kick_from(Side::kWest, 1, {-3, 2.5}, {-6, 0});
  EXPECT_TRUE(is_called(game, "corner_kick"));
}

TEST(AimlessKick, IsNotCalledFromAKickOff) {
  ScriptedGame game(by_book("2026-b"));
  game.line_up().kick_off();
  game.put_ball({-0.01, 0});  // vision sees the ball slightly off its position
  game.kick(Side::kWest, 1, 6 * Vec2(4.5, 1).normalized());
  EXPECT_TRUE(is_called(game, "goal_kick"));
}

TEST(AimlessKick, IsAllowedInDivisionA) {
  ScriptedGame game = long_kick(by_book("2026-a"), {-0.1, 3});
  EXPECT_TRUE(is_called(game, "goal_kick", 1.2));
}

}  // namespace
}  // namespace autoref::referee
