#include <gtest/gtest.h>
#include "referee/rules/rule.hpp"

#include "tests/referee/rules/rule_scene.hpp"

namespace autoref::referee {
namespace {

// West 1 kicks off softly; the ball moves by `path_m` and then lies still.
ScriptedGame kicked_off(const Configuration& configuration, double path_m) {
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.kick(Side::kWest, 1, {1, 0});
  game.run(path_m);  // at 1 m/s
  game.ball_mps = Vec2(0, 0);
  game.run(0.2);
  return game;
}

TEST(DoubleTouch, ByTheKickerGivesAnIndirectFreeKickThere) {
  ScriptedGame game = kicked_off(by_book("2014"), 0.3);
  game.kick(Side::kWest, 1, {0, 1});
  const Decision call = game.run_until("attacker_double_touched_ball", 0.5);
  EXPECT_NEAR(call.finding.value, 0.3, 0.02);
  EXPECT_EQ(call.finding.threshold, 0.05);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
  EXPECT_EQ(call.finding.robots.front(), (RobotId{Side::kWest, 1}));
  EXPECT_NEAR(call.finding.position_m->x(), 0.3, 0.02);
}

TEST(DoubleTouch, IsADirectFreeKickIfAllKicksMayScore) {
  ScriptedGame game = kicked_off(by_book("2026-b"), 0.3);
  game.kick(Side::kWest, 1, {0, 1});
  EXPECT_EQ(game.run_until("attacker_double_touched_ball", 0.5).restart(),
            (Command{CommandKind::kDirectFree, Side::kEast}));
}

TEST(DoubleTouch, IsAllowedBeforeTheBallIsInPlay) {
  ScriptedGame game = kicked_off(by_book("2014"), 0.033);  // two frames: 33 mm
  game.kick(Side::kWest, 1, {0, 1});
  EXPECT_FALSE(is_called(game, "attacker_double_touched_ball"));
}

// A longer distance and a time in which touches still belong to the kick.
TEST(DoubleTouch, FollowsTheNumbersOfTheBook) {
  const auto is_called_with = [](double RuleBook::*number, double value, double path_m) {
    Configuration configuration = by_book("2014");
    configuration.rules.*number = value;
    ScriptedGame game = kicked_off(configuration, path_m);
    game.kick(Side::kWest, 1, {0, 1});
    return is_called(game, "attacker_double_touched_ball");
  };
  EXPECT_TRUE(is_called_with(&RuleBook::double_touch_m, 0.05, 0.1));
  EXPECT_FALSE(is_called_with(&RuleBook::double_touch_m, 0.15, 0.1));
  EXPECT_TRUE(is_called_with(&RuleBook::double_touch_m, 0.15, 0.3));
  EXPECT_FALSE(is_called_with(&RuleBook::double_touch_s, 1, 0.3));
  EXPECT_TRUE(is_called_with(&RuleBook::double_touch_s, 0.2, 0.3));
}

// Whether a double touch is called if that robot touches the ball between the kicker's touches.
bool is_called_after_touch_by(RobotId other) {
  ScriptedGame game = kicked_off(by_book("2014"), 0.3);
  game.robot(Side::kWest, 1).position_m = Vec2(-0.5, 1);
  game.kick(other.side, other.number, {0, 1});
  game.run(0.3);
  game.ball_mps = Vec2(0, 0);
  game.robot(other.side, other.number).position_m = Vec2(-0.5, -1);
  game.run(0.2);
  game.kick(Side::kWest, 1, {0, 1});
  return is_called(game, "attacker_double_touched_ball");
}

TEST(DoubleTouch, IsAllowedOnceAnotherRobotHasTouchedTheBall) {
  EXPECT_FALSE(is_called_after_touch_by({Side::kEast, 2}));
  EXPECT_FALSE(is_called_after_touch_by({Side::kWest, 2}));
}

TEST(DoubleTouch, IsNotCalledForATeamMate) {
  ScriptedGame game = kicked_off(by_book("2014"), 0.3);
  game.robot(Side::kWest, 1).position_m = Vec2(-0.5, 1);
  game.kick(Side::kWest, 2, {0, 1});
  EXPECT_FALSE(is_called(game, "attacker_double_touched_ball"));
}

// The robot keeps driving after its kick, slower than the ball.
TEST(DoubleTouch, IsNotCalledIfTheRobotFollowsItsKick) {
  ScriptedGame game(by_book("2014"));
  game.line_up().kick_off();
  game.kick(Side::kWest, 1, {2, 0});
  for (int i = 0; i < 30; ++i) {
    game.robot(Side::kWest, 1).position_m.x() += 1.9 / ScriptedGame::kRate_hz;
    game.step();
  }
  EXPECT_EQ(game.count("attacker_double_touched_ball"), 0);
}

TEST(DoubleTouch, IsAllowedAfterAForceStart) {
  ScriptedGame game(by_book("2014"));
  game.line_up().kick_off();
  game.run_until("restart_not_taken");
  game.run_until("start");
  for (int i = 0; i < 2; ++i) {
    game.kick(Side::kWest, 1, {1, 0});
    game.run(0.3);
    game.ball_mps = Vec2(0, 0);
    game.run(0.2);
  }
  EXPECT_EQ(game.count("attacker_double_touched_ball"), 0);
}

TEST(DoubleTouch, IsAllowedIfTheRuleIsNotInForce) {
  ScriptedGame game = kicked_off(without(by_book("2014"), RuleId::kAttackerDoubleTouchedBall), 0.3);
  game.kick(Side::kWest, 1, {0, 1});
  EXPECT_FALSE(is_called(game, "attacker_double_touched_ball"));
}

}  // namespace
}  // namespace autoref::referee
