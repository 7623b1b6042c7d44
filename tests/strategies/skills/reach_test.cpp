#include "strategies/skills/ball_path.hpp"

#include <gtest/gtest.h>

#include "soccer/random.hpp"
#include "tests/strategies/skills/staged_bodies.hpp"

namespace autoref::strategies {
namespace {

// Time in seconds from rest to rest over `distance_m`, braking with that fraction of the robot's
// braking.
double trapezoid_s(double distance_m, double braking_share) {
  const Abilities a;
  const double brake_mps2 = braking_share * a.braking_mps2;
  const double per_peak =
      1 / a.acceleration_mps2 + 1 / brake_mps2;  // the ramps cover peak^2 / 2 times this
  if (a.speed_mps * a.speed_mps / 2 * per_peak > distance_m)
    return std::sqrt(2 * distance_m * per_peak);
  return distance_m / a.speed_mps + a.speed_mps / 2 * per_peak;
}

// A team may choose the fraction of braking that it plans with: more than half, at most all.
void expect_trapezoidal_time(double distance_m) {
  const double time_s = time_to_s(robot_at({1, 1}), Vec2(1, 1 - distance_m), Abilities{});
  EXPECT_GE(time_s, trapezoid_s(distance_m, 1.0) - 1e-9) << distance_m;
  EXPECT_LE(time_s, trapezoid_s(distance_m, 0.5)) << distance_m;
}

TEST(TimeTo, IsTheTimeOfATrapezoidalProfileFromRest) {
  expect_trapezoidal_time(0.1);
  expect_trapezoidal_time(0.5);
  expect_trapezoidal_time(1.0);
  expect_trapezoidal_time(3.0);
  expect_trapezoidal_time(8.0);
}

TEST(TimeTo, IsZeroForARobotAtRestThere) {
  EXPECT_NEAR(time_to_s(robot_at({1, 1}), {1, 1}, Abilities{}), 0, 1e-9);
}

TEST(TimeTo, IsLessWhenMovingThereAndMoreWhenMovingAway) {
  const double rest_s = time_to_s(robot_at({0, 0}), {2, 0}, Abilities{});
  EXPECT_LT(time_to_s(robot_at({0, 0}, {1.5, 0}), {2, 0}, Abilities{}), rest_s - 0.1);
  EXPECT_GT(time_to_s(robot_at({0, 0}, {-1.5, 0}), {2, 0}, Abilities{}), rest_s + 0.3);
  EXPECT_GT(time_to_s(robot_at({0, 0}, {0, 1.5}), {2, 0}, Abilities{}), rest_s);
}

TEST(TimeTo, IsLongerForSlowerRobots) {
  const double usual_s = time_to_s(robot_at({0, 0}), {4, 0}, Abilities{});
  Abilities slow;
  slow.speed_mps /= 2;
  Abilities lazy;
  lazy.acceleration_mps2 /= 2;
  EXPECT_GT(time_to_s(robot_at({0, 0}), {4, 0}, slow), usual_s + 0.5);
  EXPECT_GT(time_to_s(robot_at({0, 0}), {4, 0}, lazy), usual_s + 0.2);
}

TEST(InterceptBall, IsAtABallAtRestOnceTheRobotCanTouchIt) {
  const BallInterception interception =
      intercept(robot_at({-1, 0}), path_of({{1, 0}, {0, 0}}), Abilities{}, Field{});
  EXPECT_EQ(interception.point_m, Vec2(1, 0));
  EXPECT_GE(interception.time_s, trapezoid_s(2 - kHeldBall_m, 1.0));
  EXPECT_LE(interception.time_s, trapezoid_s(2 - kHeldBall_m, 0.5));
}

TEST(InterceptBall, IsImmediateForARobotThatHasTheBall) {
  const BallInterception interception =
      intercept(robot_at({0, 0}), path_of({{kHeldBall_m, 0}, {0, 0}}), Abilities{}, Field{});
  EXPECT_NEAR(interception.time_s, 0, 0.02);
}

class InterceptRollingBallFrom : public testing::TestWithParam<Vec2> {};

TEST_P(InterceptRollingBallFrom, IsWhereTheRobotArrivesNoLaterThanTheBall) {
  const CarpetBall ball{{-2, 0}, {1, 0}, 3};
  const BallInterception interception =
      intercept(robot_at(GetParam()), path_of(ball.at(0)), Abilities{}, Field{});
  EXPECT_NEAR(interception.point_m.y(), 0, 1e-6);
  EXPECT_NEAR(ball.at(interception.time_s).position_m.x(), interception.point_m.x(), 0.1);
  const double touch_m = (interception.point_m - GetParam()).norm() - kHeldBall_m;
  EXPECT_LE(trapezoid_s(std::max(0.0, touch_m), 1.0), interception.time_s + 0.1);
}

INSTANTIATE_TEST_SUITE_P(Robot, InterceptRollingBallFrom,
                         testing::Values(Vec2(0, 1), Vec2(-1, -1), Vec2(1, 0.3)), name_of_place);

// The first step at which the robot is no later than the ball, found without any shortcut.
int first_step_in_time(const TrackedRobot& robot, const BallPath& path) {
  for (int step = 0; step <= BallPath::kSteps; step += 2) {
    const Vec2 back = (robot.position_m - path.at_step(step)).normalized();
    const Vec2 touch_m = path.at_step(step) + back * kHeldBall_m;
    if (time_to_s(robot, touch_m, Abilities{}) <= step * BallPath::kStep_s) return step;
  }
  return BallPath::kSteps;
}

TEST(InterceptBall, IsJustBeforeTheFirstStepAtWhichTheRobotIsInTime) {
  RandomStream random(7);
  const auto within = [&](double most) { return most * (2 * random.uniform() - 1); };
  const BallPath path = path_of({{-2, 0.5}, {2, 0}});
  int reached = 0;
  for (int i = 0; i < 1000; ++i) {
    const TrackedRobot robot = robot_at({within(3), within(2)}, {within(3.5), within(3.5)});
    const int step = first_step_in_time(robot, path);
    if (step == 0 || step == BallPath::kSteps) continue;
    ++reached;
    const double time_s = intercept(robot, path, Abilities{}, Field{}).time_s;
    EXPECT_LE(time_s, step * BallPath::kStep_s + 1e-9);
    EXPECT_GE(time_s, (step - 2) * BallPath::kStep_s - 1e-9);
  }
  EXPECT_GT(reached, 300);
}

TEST(InterceptBall, IsEarlyOnThePathForARobotNearIt) {
  const BallPath path = path_of({{-2, 0}, {2, 0}});
  const BallInterception near = intercept(robot_at({-1.5, 0.2}), path, Abilities{}, Field{});
  const BallInterception far = intercept(robot_at({0.5, 1.5}), path, Abilities{}, Field{});
  EXPECT_LT(near.point_m.x(), far.point_m.x());
  EXPECT_LT(near.time_s, far.time_s);
}

TEST(InterceptBall, IsAtThePathsEndIfTheRobotCannotCatchUp) {
  const Field field = team_context_of("2026-a").field;
  const BallPath path = path_of({{-5, 0}, {6, 0}});
  const BallInterception interception = intercept(robot_at({-5.8, 0}), path, Abilities{}, field);
  EXPECT_LT((interception.point_m - path.end_m()).norm(), 0.01);
  EXPECT_GT(interception.time_s, BallPath::kLongest_s);
}

TEST(InterceptBall, IsNotOutsideTheField) {
  const Field field;
  const BallInterception interception =
      intercept(robot_at({0, 1.5}), path_of({{2.5, 0}, {3, 0}}), Abilities{}, field);
  EXPECT_LT(interception.point_m.x(), field.half_length_m() + 0.2);
}

double time_to_ball_s(const Abilities& abilities, const Vec2& ball_mps) {
  return intercept(robot_at({0, 1.5}), path_of({{-2, 0}, ball_mps}), abilities, Field{}).time_s;
}

TEST(InterceptBall, IsLaterForSlowerRobots) {
  Abilities slow;
  slow.speed_mps /= 2;
  slow.acceleration_mps2 /= 2;
  EXPECT_GT(time_to_ball_s(slow, {0, 0}), time_to_ball_s({}, {0, 0}) + 0.1);
  EXPECT_GT(time_to_ball_s(slow, {1.5, 0}), time_to_ball_s({}, {1.5, 0}) + 0.1);
}

}  // namespace
}  // namespace autoref::strategies
