#include "strategies/skills/strike.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/skills/staged_bodies.hpp"

namespace autoref::strategies {
namespace {

TrackedRobot facing_robot_at(const Vec2& position_m, const Vec2& heading = {1, 0}) {
  return {0, position_m, heading, Vec2(0, 0), 0};
}

RobotCommand strike(const TrackedRobot& robot, const TrackedBall& ball, const Strike& strike) {
  const BallPath path = path_of(ball);
  return strike_ball(robot, path, intercept(robot, path, Abilities{}, Field{}), strike, {},
                     DrivingStyle{});
}

Strike strike_at(const Vec2& target_m) {
  Strike strike;
  strike.target_m = target_m;
  return strike;
}

class KickHeading : public testing::TestWithParam<Vec2> {};

// Whatever the ball's motion, it leaves along the aim.
TEST_P(KickHeading, SendsAMovingBallAlongTheAim) {
  const Vec2 aim = heading_of(0.7);
  const Vec2 heading = kick_heading(aim, 6, GetParam());
  EXPECT_NEAR(heading.norm(), 1, 1e-9);
  EXPECT_NEAR(angle_between(aim, kicked_mps(heading, 6, GetParam())), 0, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Ball, KickHeading,
                         testing::Values(Vec2(0, 0), Vec2(0, 2), Vec2(1.5, -1), Vec2(-4, 1),
                                         Vec2(-2, -3)));

TEST(KickHeading, IsTheAimWithoutAKick) { EXPECT_EQ(kick_heading({0, 1}, 0, {3, 0}), Vec2(0, 1)); }

TEST(HasBall, IsTrueForABallAtThePlate) {
  EXPECT_TRUE(has_ball(facing_robot_at({1, 1}), {1 + kHeldBall_m, 1}));
  EXPECT_TRUE(has_ball(facing_robot_at({1, 1}, {0, -1}), {1, 1 - kHeldBall_m}));
  EXPECT_TRUE(has_ball(facing_robot_at({0, 0}), {kHeldBall_m + 5_mm, kDribblerZoneWidth_m / 4}));
}

TEST(HasBall, IsFalseForABallAheadBesideOrBehind) {
  EXPECT_FALSE(has_ball(facing_robot_at({0, 0}), {kHeldBall_m + 30_mm, 0}));
  EXPECT_FALSE(has_ball(facing_robot_at({0, 0}), {kHeldBall_m, kDribblerZoneWidth_m / 2 + 20_mm}));
  EXPECT_FALSE(has_ball(facing_robot_at({0, 0}), {0, kHeldBall_m}));
  EXPECT_FALSE(has_ball(facing_robot_at({0, 0}), {-kHeldBall_m, 0}));
}

TEST(ComesTowards, IsTrueForAPassThatArrivesHere) {
  EXPECT_TRUE(comes_towards(facing_robot_at({2, 0.1}), path_of({{0, 0}, {3, 0}})));
}

TEST(ComesTowards, IsFalseForSlowBallsAndBallsThatGoElsewhere) {
  EXPECT_FALSE(comes_towards(facing_robot_at({2, 0.1}), path_of({{0, 0}, {0.5, 0}})));
  EXPECT_FALSE(comes_towards(facing_robot_at({2, 0.1}), path_of({{0, 0}, {-3, 0}})));
  EXPECT_FALSE(comes_towards(facing_robot_at({2, 1.1}), path_of({{0, 0}, {3, 0}})));
}

// Angle in radians from the robot's heading to the target, seen from the ball.
double error_rad(const TrackedRobot& robot, const Vec2& ball_m, const Vec2& target_m) {
  return std::abs(angle_between(robot.heading, target_m - ball_m));
}

class StrikeBallFrom : public testing::TestWithParam<Vec2> {};

// Lets the robot play a ball at the origin until it kicks it, for at most 5 s. Returns whether it
// did; it must never try to while it faces elsewhere.
bool strikes_only_at(const Vec2& target_m, TrackedRobot& robot) {
  for (int i = 0; i < 300; ++i) {
    const RobotCommand command = strike(robot, {{0, 0}, {0, 0}}, strike_at(target_m));
    const double most_rad = command.kick_mps > 0 ? 2 * Strike{}.tolerance_rad : 2 * kPi;
    EXPECT_LT(error_rad(robot, {0, 0}, target_m), most_rad) << i;
    if (command.kick_mps > 0 && has_ball(robot, {0, 0})) return true;
    obey(robot, command);
  }
  return false;
}

TEST_P(StrikeBallFrom, KicksABallAtRestOnlyWhenItFacesTheTarget) {
  TrackedRobot robot = facing_robot_at(GetParam(), {0, 1});
  EXPECT_TRUE(strikes_only_at({3, 0.5}, robot));
}

INSTANTIATE_TEST_SUITE_P(Robot, StrikeBallFrom,
                         testing::Values(Vec2(-1, 0.3), Vec2(-0.8, -0.9), Vec2(0.1, 1.2)),
                         name_of_place);

// Turns a robot for at most 150 frames until it kicks. Returns the number of frames before that.
// The dribbler holds the ball, so the ball turns with the robot.
int frames_with_ball_before_kick(TrackedRobot& robot) {
  for (int frame = 0; frame < 150; ++frame) {
    const Vec2 ball_m = robot.position_m + robot.heading * kHeldBall_m;
    const RobotCommand command = strike(robot, {ball_m, {0, 0}}, strike_at({3, 0}));
    EXPECT_TRUE(command.dribble) << frame;
    if (command.kick_mps > 0) return frame;
    obey(robot, command);
  }
  return 150;
}

TEST(StrikeBall, TurnsAroundWithTheBallBeforeItKicks) {
  TrackedRobot robot = facing_robot_at({0, 0}, {-1, 0.1});
  robot.heading.normalize();
  const int frames = frames_with_ball_before_kick(robot);
  EXPECT_GT(frames, 15);  // no robot makes half a turn in 0.25 s
  EXPECT_LT(frames, 120);
  EXPECT_LT(error_rad(robot, robot.position_m, {3, 0}), 2 * Strike{}.tolerance_rad);
}

// In a steady turn the dribbler holds the ball up to 10 rad/s (sim/README.md).
TEST(StrikeBall, PressesGentlyAgainstTheBallWhileTurning) {
  const RobotCommand command =
      strike(facing_robot_at({0, 0}, {-1, 0}), {{-kHeldBall_m, 0}, {0, 0}}, strike_at({3, 0.5}));
  EXPECT_GT(command.velocity_mps.x(), 0.1);
  EXPECT_LT(command.velocity_mps.norm(), 0.45);
  EXPECT_LT(std::abs(command.angular_velocity_radps), 9);
}

TEST(StrikeBall, KicksAPassFirstTimeIfTheAngleAllows) {
  const Vec2 direction = Vec2(-2, -1).normalized();
  const TrackedRobot robot = facing_robot_at({1, 0}, kick_heading({1, 0}, 7, direction * 3));
  const Vec2 dribbler_zone_m = robot.position_m + robot.heading * kHeldBall_m;
  Strike on = strike_at({3, 0});
  on.kick_mps = 7;
  const RobotCommand command = strike(robot, {dribbler_zone_m - direction, direction * 3}, on);
  EXPECT_EQ(command.kick_mps, 7);
  EXPECT_NEAR(command.angular_velocity_radps, 0, 0.5);
}

TEST(StrikeBall, TurnsToTheTargetForAPassIfTheAngleAllows) {
  TrackedRobot robot = facing_robot_at({1, 0}, {0, 1});
  const Vec2 direction = Vec2(-2, -1).normalized();
  const RobotCommand command =
      strike(robot, {Vec2(1 + kHeldBall_m, 0) - direction * 2, direction * 3}, strike_at({3, 0}));
  EXPECT_EQ(command.kick_mps, 0);
  EXPECT_LT(command.angular_velocity_radps, -1);
}

TEST(StrikeBall, StopsAPassFromBehindWithTheDribbler) {
  const TrackedRobot robot = facing_robot_at({1, 0});
  const RobotCommand command = strike(robot, {{-1, 0.3}, Vec2(3, -0.45)}, strike_at({3, 0}));
  EXPECT_EQ(command.kick_mps, 0);
  EXPECT_TRUE(command.dribble);
  EXPECT_GT(std::abs(command.angular_velocity_radps), 1);  // turns its front to the ball
}

TEST(StrikeBall, StopsAPassIfTheFirstTouchMustNotBeAKick) {
  Strike calm = strike_at({3, 0});
  calm.first_touch = false;
  const RobotCommand command = strike(facing_robot_at({1, 0}), {{2.5, 0}, {-3, 0}}, calm);
  EXPECT_EQ(command.kick_mps, 0);
  EXPECT_TRUE(command.dribble);
}

TEST(StrikeBall, ChipsIfItIsCommandedTo) {
  Strike over = strike_at({3, 0});
  over.chip = true;
  over.kick_mps = 4;
  const RobotCommand command = strike(facing_robot_at({0, 0}), {{kHeldBall_m, 0}, {0, 0}}, over);
  EXPECT_TRUE(command.chip);
  EXPECT_EQ(command.kick_mps, 4);
}

class TakeKickFrom : public testing::TestWithParam<Vec2> {};

// Lets the robot take a kick within 6 s. Returns whether its first touch of the ball is the kick.
bool first_touch_is_kick(TrackedRobot& robot) {
  for (int frame = 0; frame < 360; ++frame) {
    const RobotCommand command = take_kick(robot, {0, 0}, strike_at({3, 0.5}), {}, DrivingStyle{});
    obey(robot, command);
    if (distance_to_hull({0, 0}, robot.position_m, robot.heading) < kBallRadius_m)
      return command.kick_mps > 0;
  }
  return false;
}

// From beside, behind and in front of the ball. A robot that touched the ball before its kick would
// have taken the restart by mistake.
TEST_P(TakeKickFrom, GoesAroundABallAtRestAndKicksItInOneTouch) {
  TrackedRobot robot = facing_robot_at(GetParam(), {0, 1});
  EXPECT_TRUE(first_touch_is_kick(robot));
  EXPECT_LT(error_rad(robot, {0, 0}, {3, 0.5}), 2 * Strike{}.tolerance_rad);
}

INSTANTIATE_TEST_SUITE_P(Robot, TakeKickFrom,
                         testing::Values(Vec2(-0.6, 0), Vec2(0, 0.7), Vec2(0.65, 0.05),
                                         Vec2(0.3, -0.5)),
                         name_of_place);

// The heading of a robot coming from the field's middle when it gets a ball near the touch line.
Vec2 heading_at_ball(const Vec2& keep_off) {
  const Vec2 ball_m(0, Field{}.half_width_m() - 0.1);
  Strike to_goal = strike_at({3, 0});
  to_goal.bend_rad = 0.1;
  to_goal.keep_off = keep_off;
  TrackedRobot robot = facing_robot_at({-0.2, 0.8}, {0, 1});
  for (int frame = 0; frame < 180 && !has_ball(robot, ball_m); ++frame)
    obey(robot, strike(robot, {ball_m, {0, 0}}, to_goal));
  return robot.heading;
}

TEST(StrikeBall, DoesNotFaceOutOfTheFieldAtABallNearTheLine) {
  EXPECT_LT(heading_at_ball({0, 1}).y(), 0.3);
  EXPECT_GT(heading_at_ball({0, 0}).y(), 0.7);  // farther inside, it approaches straight
}

TEST(CarryBall, KeepsTheDribblerOnAndDoesNotKick) {
  const RobotCommand command = carry_ball(facing_robot_at({0, 0}, {0, 1}), {0, 0.8}, {1, 0});
  EXPECT_TRUE(command.dribble);
  EXPECT_EQ(command.kick_mps, 0);
  EXPECT_NEAR((command.velocity_mps - Vec2(0.8, 0)).norm(), 0,
              1e-9);  // forwards, because it faces +y
}

TEST(CarryBall, TurnsInTheShorterDirection) {
  EXPECT_LT(carry_ball(facing_robot_at({0, 0}, {0, 1}), {0, 0}, {1, 0}).angular_velocity_radps, -1);
  EXPECT_GT(carry_ball(facing_robot_at({0, 0}, {0, -1}), {0, 0}, {1, 0}).angular_velocity_radps, 1);
}

}  // namespace
}  // namespace autoref::strategies
