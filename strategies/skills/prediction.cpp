#include "strategies/skills/prediction.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies {
namespace {

constexpr double kBallSlowing_mps2 = 0.5;
constexpr double kLongestWait_s = BallSamples::time_s(BallSamples::kSteps);
constexpr double kCruise_mps = 2.2;
constexpr double kPredictedStill_mps = 0.1;
constexpr double kStartUp_s = 0.25;
constexpr double kPredictedMargin_m = 1e-6;  // far above rounding errors

void move_on(TrackedRobots& robots, double ahead_s) {
  for (TrackedRobot& robot : robots) {
    robot.position_m += robot.velocity_mps * ahead_s;
    // Small-angle approximation: the vector keeps its length to second order.
    robot.heading = direction_of(
        robot.heading + left_of(robot.heading) * (robot.angular_velocity_radps * ahead_s),
        robot.heading);
  }
}

Vec2 ball_after(const TrackedBall& ball, double speed_mps, double ahead_s) {
  if (speed_mps < 0.02) return ball.position_m;
  const double t = std::min(ahead_s, speed_mps / kBallSlowing_mps2);
  return ball.position_m + ball.velocity_mps * (t - kBallSlowing_mps2 * t * t / (2 * speed_mps));
}

}  // namespace

Vec2 ball_after(const TrackedBall& ball, double ahead_s) {
  return ball_after(ball, ball.velocity_mps.norm(), ahead_s);
}

void look_ahead(const TeamView& view, TeamView& ahead) {
  ahead = view;
  move_on(ahead.own, view.latency_s);
  move_on(ahead.opponents, view.latency_s);
  ahead.ball.position_m = ball_after(view.ball, view.latency_s);
}

double travel_time_s(const TrackedRobot& robot, const Vec2& point_m) {
  const Vec2 offset = point_m - robot.position_m;
  const double distance_m = offset.norm();
  // The estimate assumes cruising speed all the way, plus a start-up time that is shorter if the
  // robot is already moving in that direction.
  const double closing_mps = distance_m < 1e-6 ? 0.0 : robot.velocity_mps.dot(offset) / distance_m;
  return std::max(0.0, distance_m / kCruise_mps + kStartUp_s * (1.0 - closing_mps / kCruise_mps));
}

BallSamples::BallSamples(const TrackedBall& ball)
    : lies_still_(ball.velocity_mps.squaredNorm() < kPredictedStill_mps * kPredictedStill_mps) {
  const double speed_mps = ball.velocity_mps.norm();
  const int last = lies_still_ ? 0 : kSteps;
  for (int i = 0; i <= last; ++i)
    points_m_[static_cast<std::size_t>(i)] = ball_after(ball, speed_mps, time_s(i));
}

// Looks for the first time at which the robot arrives at about the same time as the ball.
Interception intercept(const TrackedRobot& robot, const BallSamples& ball) {
  if (ball.lies_still()) return {ball.at(0), travel_time_s(robot, ball.at(0))};
  const double head_start_m = kStartUp_s * robot.velocity_mps.norm() + kPredictedMargin_m;
  for (int i = 0; i < BallSamples::kSteps; ++i) {
    const double t = BallSamples::time_s(i);
    // The point is out of reach even if the robot were already moving towards it.
    if ((robot.position_m - ball.at(i)).squaredNorm() > square(kCruise_mps * t + head_start_m))
      continue;
    const double travel_s = travel_time_s(robot, ball.at(i));
    if (travel_s <= t + kStartUp_s) return {ball.at(i), std::max(t, travel_s)};
  }
  const Vec2& point_m = ball.at(BallSamples::kSteps);
  return {point_m, std::max(kLongestWait_s, travel_time_s(robot, point_m))};
}

Interception intercept(const TrackedRobot& robot, const TrackedBall& ball) {
  return intercept(robot, BallSamples(ball));
}

}  // namespace autoref::strategies
