// Touches of the ball in the defence areas: rules defender_in_defense_area and
// attacker_touched_ball_in_defense_area. A robot that kicks along x has its plate 22.5 mm behind
// the ball's centre, including the scripted millimetre, and its back 187.5 + 1 mm behind.
#include <gtest/gtest.h>

#include "referee/rules/rule.hpp"
#include "tests/referee/rules/rule_scene.hpp"

namespace autoref::referee {
namespace {

// West 1 kicks the ball in play from that position, along x.
ScriptedGame kicked_at_area(const Configuration& configuration, double ball_x_m) {
  ScriptedGame game = in_play(configuration);
  game.kick_from(Side::kWest, 1, {ball_x_m, 0}, {2, 0});
  return game;
}

// West's area of 2014 ends at x = -2.225 in front of the goal, where the line is straight.
TEST(DefenderInArea, EntirelyInsideGivesAPenaltyKick) {
  ScriptedGame game = kicked_at_area(by_book("2014"), -2.225 + 0.0225 - 0.001);
  const Decision call = game.run_until("defender_in_defense_area", 0.3);
  EXPECT_NEAR(call.finding.value, -0.001, 1e-6);
  EXPECT_NEAR(call.finding.details.robot_m->x(), -2.225 - 0.001 - kFrontDistance_m, 1e-6);
  EXPECT_EQ(call.restart(), (Command{CommandKind::kPreparePenalty, Side::kEast}));
  EXPECT_EQ(call.finding.robots.front(), (RobotId{Side::kWest, 1}));
  EXPECT_NEAR(game.signal.placement->target_m.x(), -3.025 + 0.75, 1e-9);  // the mark
  EXPECT_EQ(game.signal.yellow_cards[Side::kWest], 0);
}

TEST(DefenderInArea, PartlyInsideGivesAYellowCardAndAnIndirectFreeKick) {
  for (const double ball_x_m : {-2.225 + 0.0225 + 0.001, -2.225 + 0.1885 - 0.001}) {
    ScriptedGame game = kicked_at_area(by_book("2014"), ball_x_m);
    const Decision call = game.run_until("defender_in_defense_area_partially", 0.3);
    EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
    EXPECT_EQ(game.signal.yellow_cards[Side::kWest], 1);
    EXPECT_EQ(game.count("defender_in_defense_area"), 0);
  }
}

TEST(DefenderInArea, IsNotCalledOutsideTheLine) {
  ScriptedGame game = kicked_at_area(by_book("2014"), -2.225 + 0.1885 + 0.001);
  game.run(0.5);
  EXPECT_EQ(game.count("defender_in_defense_area_partially"), 0);
}

TEST(DefenderInArea, IsNotCalledForTheKeeper) {
  ScriptedGame game = in_play(by_book("2014"));
  game.requests[Side::kWest].keeper = 1;
  game.kick_from(Side::kWest, 1, {-2.5, 0}, {2, 0});
  EXPECT_FALSE(is_called(game, "defender_in_defense_area", 0.5));
}

TEST(DefenderInArea, PartlyInsideIsAllowedIn2026) {
  ScriptedGame partly = kicked_at_area(by_book("2026-b"), -3.5 + 0.0225 + 0.001);
  partly.run(0.5);
  EXPECT_EQ(partly.count("defender_in_defense_area_partially"), 0);
  ScriptedGame entirely = kicked_at_area(by_book("2026-b"), -3.5 + 0.0225 - 0.001);
  EXPECT_TRUE(is_called(entirely, "defender_in_defense_area", 0.5));
}

TEST(DefenderInArea, IsCalledIfAnOpponentMayHavePushed) {
  ScriptedGame game = in_play(by_book("2014"));
  RobotObservation& opponent = game.robot(Side::kEast, 3);
  opponent.position_m = Vec2(-2.5 - 0.0975, 0.18 + 0.002);
  game.kick_from(Side::kWest, 1, {-2.5, 0}, {2, 0});
  EXPECT_TRUE(is_called(game, "defender_in_defense_area", 0.5));
}

TEST(DefenderInArea, CountsWhereTheRobotWasAtTheTouch) {
  ScriptedGame game = kicked_at_area(by_book("2014"), -2.225 + 0.1885 + 0.003);
  game.run(1 / ScriptedGame::kRate_hz);
  game.robot(Side::kWest, 1).position_m.x() -= 0.05;  // enters only now, at 3 m/s
  game.run(0.5);
  EXPECT_EQ(game.count("defender_in_defense_area_partially"), 0);
}

TEST(DefenderInArea, IsAllowedIfTheRuleIsNotInForce) {
  ScriptedGame game =
      kicked_at_area(without(by_book("2014"), RuleId::kDefenderInDefenseArea), -2.5);
  EXPECT_FALSE(is_called(game, "defender_in_defense_area", 0.5));
}

// East's area of Division B begins at x = 3.5.
TEST(AttackerInArea, PartlyInsideIsAFoulThatDoesNotStopPlay) {
  ScriptedGame game = kicked_at_area(by_book("2026-b"), 3.5 + 0.0225 + 0.001);
  const Decision call = game.run_until("attacker_touched_ball_in_defense_area", 0.3);
  EXPECT_NEAR(call.finding.value, -0.001, 1e-6);
  EXPECT_EQ(call.to, State::kRun);
  EXPECT_TRUE(call.finding.is_foul);
  game.run(1);
  EXPECT_EQ(game.count("attacker_touched_ball_in_defense_area"), 1);
}

TEST(AttackerInArea, IsNotCalledOutsideTheLine) {
  ScriptedGame game = kicked_at_area(by_book("2026-b"), 3.5 + 0.0225 - 0.001);
  EXPECT_FALSE(is_called(game, "attacker_touched_ball_in_defense_area", 0.3));
}

TEST(AttackerInArea, IsAllowedInTheLawsOf2014) {
  ScriptedGame game = kicked_at_area(by_book("2014"), 2.5);
  EXPECT_FALSE(is_called(game, "attacker_touched_ball_in_defense_area", 0.2));
}

}  // namespace
}  // namespace autoref::referee
