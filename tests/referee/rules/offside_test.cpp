#include <gtest/gtest.h>
#include "referee/rules/rule.hpp"

#include "tests/referee/rules/rule_scene.hpp"

namespace autoref::referee {
namespace {

Configuration with_offside() {
  Configuration configuration;
  configuration.rules.in_force[RuleId::kOffside] = true;
  return configuration;
}

// West 2 passes along x from `ball_x_m` to west 3, whose centre is at `receiver_x_m`. East has
// three robots each at x = 1.75 and 2.0. The pass is the second touch of play.
ScriptedGame passed(ScriptedGame game, double ball_x_m, double receiver_x_m) {
  game.kick_from(Side::kEast, 5, {0, 1.2}, {0, 0.5});
  game.run(0.2);
  game.put_ball({ball_x_m, 0.2});
  RobotObservation& receiver = game.robot(Side::kWest, 3);
  receiver.position_m = Vec2(receiver_x_m, 0.2);
  receiver.heading = Vec2(-1, 0);
  game.run(0.1);
  game.kick(Side::kWest, 2, {3, 0});
  const double meets_x_m = receiver_x_m - kFrontDistance_m - kBallRadius_m;
  while (game.frame.ball->position_m.x() < meets_x_m) game.step();
  game.put_ball({meets_x_m, 0.2});
  game.ball_mps = Vec2(-1, 0);
  game.run(0.3);
  return game;
}

TEST(Offside, IsCalledForAPassBeyondTheSecondLastOpponent) {
  const ScriptedGame game = passed(in_play(with_offside()), 1, 2.01);
  ASSERT_EQ(game.count("offside"), 1);
  const Decision& call = game.decisions.back();
  EXPECT_EQ(call.finding.robots.front(), (RobotId{Side::kWest, 3}));
  EXPECT_EQ(call.restart(), (Command{CommandKind::kIndirectFree, Side::kEast}));
}

TEST(Offside, IsNotCalledLevelWithTheSecondLastOpponent) {
  EXPECT_EQ(passed(in_play(with_offside()), 1, 1.99).count("offside"), 0);
}

TEST(Offside, IsNotCalledInTheOwnHalf) {
  ScriptedGame game = in_play(with_offside());
  for (RobotObservation& robot : game.frame.robots[Side::kEast]) robot.position_m.x() -= 3;
  EXPECT_EQ(passed(std::move(game), -0.9, -0.02).count("offside"), 0);
}

TEST(Offside, IsNotCalledBehindTheBall) {
  ScriptedGame game = in_play(with_offside());
  for (RobotObservation& robot : game.frame.robots[Side::kEast]) robot.position_m.x() -= 1.5;
  game.kick_from(Side::kEast, 5, {0, 1.2}, {0, 0.5});
  game.run(0.2);
  game.put_ball({1.2, 0.9});
  game.robot(Side::kWest, 3).position_m = Vec2(1.1, -0.6);
  game.robot(Side::kWest, 3).heading = Vec2(0, 1);
  game.run(0.1);
  game.kick(Side::kWest, 2, {-0.3, -3});  // backwards
  while (game.frame.ball->position_m.y() > -0.6 + 0.09) game.step();
  game.ball_mps = Vec2(0, 1);
  game.run(0.3);
  EXPECT_EQ(game.count("offside"), 0);
}

TEST(Offside, IsNotCalledWithinTheNoise) {
  Configuration configuration = with_offside();
  configuration.noise.robot_m = 0.005;  // three standard deviations of two positions: 21 mm
  EXPECT_EQ(passed(in_play(configuration), 1, 2.02).count("offside"), 0);
  EXPECT_EQ(passed(in_play(configuration), 1, 2.03).count("offside"), 1);
}

TEST(Offside, IsNotCalledStraightFromARestart) {
  ScriptedGame game(with_offside());
  game.line_up().kick_off();
  RobotObservation& receiver = game.robot(Side::kWest, 3);
  receiver.position_m = Vec2(2.2, 0.2);
  receiver.heading = Vec2(-1, 0);
  game.kick(Side::kWest, 2, {3, 0.3});
  while (game.frame.ball->position_m.x() < 2.2 - 0.0965) game.step();
  game.ball_mps = Vec2(-1, 0);
  game.run(0.3);
  EXPECT_EQ(game.count("offside"), 0);
}

TEST(Offside, IsAllowedInEveryBookOfTheLeague) {
  EXPECT_EQ(passed(in_play(), 1, 2.2).count("offside"), 0);
  for (const std::string& book : rule_book_names()) {
    EXPECT_FALSE(find_rule_book(book)->has(RuleId::kOffside)) << book;
  }
}

}  // namespace
}  // namespace autoref::referee
