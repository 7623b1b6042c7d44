#include "strategies/skills/look_ahead.hpp"

#include <gtest/gtest.h>

#include "soccer/robot_shape.hpp"
#include "tests/strategies/skills/staged_bodies.hpp"

namespace autoref::strategies {
namespace {

constexpr double kFrame_s = 1.0 / 60;

// A team of one robot at the origin, seen in frame 100 with a delay of `frames`.
struct Delayed {
  explicit Delayed(double frames) {
    view.frame = 100;
    view.latency_s = frames * kFrame_s;
    view.own.push_back({0, {0, 0}, {1, 0}, {0, 0}, 0});
    view.ball.position_m = {2, 0};
  }
  void sent(std::int64_t frame, const Vec2& velocity_mps, double turn_radps = 0) {
    TeamCommands commands;
    commands[0].velocity_mps = velocity_mps;
    commands[0].angular_velocity_radps = turn_radps;
    commands[0].dribble = true;
    look_ahead.note(frame, commands);
  }
  const TrackedRobot& robot() {
    held = look_ahead.look(view, ahead);
    return ahead.own[0];
  }

  LookAhead look_ahead{LookAhead::TeamAbilities{}, 60};
  TeamView view;
  TeamView ahead;
  bool held = false;
};

// From rest at 3 m/s^2.
TEST(LookAhead, FollowsTheCommandsThatAreOnTheirWay) {
  Delayed team(5);
  for (int frame = 95; frame < 100; ++frame) team.sent(frame, {2, 0});
  const double delay_s = 5 * kFrame_s;
  EXPECT_NEAR(team.robot().velocity_mps.x(), 3 * delay_s, 1e-9);
  EXPECT_NEAR(team.robot().position_m.x(), 3 * delay_s * delay_s / 2, 1e-9);
}

TEST(LookAhead, KnowsThatAnOlderCommandHasTakenEffect) {
  Delayed team(5);
  team.sent(94, {0, 2});
  for (int frame = 95; frame < 100; ++frame) team.sent(frame, {0, 0});
  EXPECT_NEAR(team.robot().position_m.norm(), 0, 1e-9);
}

// 2.4 frames: the oldest command on its way still lasts for 0.4 frames.
TEST(LookAhead, FollowsTheOldestCommandForThePartOfAFrameThatIsLeft) {
  Delayed team(2.4);
  team.sent(97, {2, 0});
  team.sent(98, {0, 0});
  team.sent(99, {2, 0});
  const double top_mps = 3 * 0.4 * kFrame_s;
  EXPECT_NEAR(team.robot().velocity_mps.x(), 3 * kFrame_s, 1e-9);  // stopped meanwhile
  EXPECT_GT(team.robot().position_m.x(), top_mps * 0.2 * kFrame_s);
}

TEST(LookAhead, BrakesAt5MetresPerSecondSquared) {
  Delayed team(4);
  team.view.own[0].velocity_mps = {1, 0};
  for (int frame = 96; frame < 100; ++frame) team.sent(frame, {0, 0});
  EXPECT_NEAR(team.robot().velocity_mps.x(), 1 - 5 * 4 * kFrame_s, 1e-9);
}

TEST(LookAhead, WithoutCommandsTheRobotKeepsItsMotion) {
  Delayed team(6);
  team.view.own[0].velocity_mps = {1, -1};
  EXPECT_NEAR((team.robot().position_m - Vec2(0.1, -0.1)).norm(), 0, 1e-9);
}

TEST(LookAhead, ABallAtTheDribblerMovesWithItsRobot) {
  Delayed team(6);
  team.view.ball.position_m = {kHeldBall_m, 0};
  team.view.own[0].angular_velocity_radps = 5;
  for (int frame = 94; frame < 100; ++frame) team.sent(frame, {0, 0}, 5);
  const TrackedRobot& robot = team.robot();
  EXPECT_TRUE(team.held);
  EXPECT_NEAR(angle_of(robot.heading), 0.5, 0.01);
  EXPECT_NEAR((team.ahead.ball.position_m - robot.heading * kHeldBall_m).norm(), 0, 1e-9);
  EXPECT_NEAR(team.ahead.ball.velocity_mps.norm(), 5 * kHeldBall_m, 1e-9);
}

TEST(LookAhead, AnotherBallKeepsItsMotion) {
  Delayed team(6);
  team.view.ball.velocity_mps = {1, 0};
  team.sent(99, {0, 0});
  team.robot();
  EXPECT_FALSE(team.held);
  EXPECT_NEAR(team.ahead.ball.position_m.x(), 2.1, 0.003);
}

}  // namespace
}  // namespace autoref::strategies
