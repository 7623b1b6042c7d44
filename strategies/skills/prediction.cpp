#include "strategies/skills/prediction.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies {
namespace {

constexpr double kBallSlowing_mps2 = 0.5;
constexpr double kLongestWait_s = 2.0;
constexpr int kTimeSteps = 20;  // up to kLongestWait_s
constexpr double kCruise_mps = 2.2;
constexpr double kPredictedStill_mps = 0.1;
constexpr double kStartUp_s = 0.25;

void move_on(TrackedRobots& robots, double ahead_s) {
  for (TrackedRobot& robot : robots) {
    robot.position_m += robot.velocity_mps * ahead_s;
    // Small-angle approximation: the vector keeps its length to second order.
    robot.heading = direction_of(
        robot.heading + left_of(robot.heading) * (robot.angular_velocity_radps * ahead_s),
        robot.heading);
  }
}

}  // namespace

Vec2 ball_after(const TrackedBall& ball, double ahead_s) {
  const double speed_mps = ball.velocity_mps.norm();
  if (speed_mps < 0.02) return ball.position_m;
  const double t = std::min(ahead_s, speed_mps / kBallSlowing_mps2);
  return ball.position_m + ball.velocity_mps * (t - kBallSlowing_mps2 * t * t / (2 * speed_mps));
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
  // Assumes cruise speed all the way, plus a start-up time that is shorter if the robot already
  // moves in that direction.
  const double closing_mps = distance_m < 1e-6 ? 0.0 : robot.velocity_mps.dot(offset) / distance_m;
  return std::max(0.0, distance_m / kCruise_mps + kStartUp_s * (1.0 - closing_mps / kCruise_mps));
}

// Samples the ball's path for the first time at which the robot arrives about when the ball does.
Interception intercept(const TrackedRobot& robot, const TrackedBall& ball) {
  for (int i = 0; i < kTimeSteps; ++i) {
    const double t = kLongestWait_s * i / kTimeSteps;
    const Vec2 point_m = ball_after(ball, t);
    const double travel_s = travel_time_s(robot, point_m);
    const bool lies_still =
        ball.velocity_mps.squaredNorm() < kPredictedStill_mps * kPredictedStill_mps;
    if (lies_still || travel_s <= t + kStartUp_s) return {point_m, std::max(t, travel_s)};
  }
  const Vec2 point_m = ball_after(ball, kLongestWait_s);
  return {point_m, std::max(kLongestWait_s, travel_time_s(robot, point_m))};
}

}  // namespace autoref::strategies
