#include "strategies/skills/shot.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr int kAimPoints = 9;
constexpr int kPushSteps = 3;  // directions to each side of straight ahead
constexpr double kWidestPush_rad = 90_deg;
constexpr double kPush_m = 1.0;
constexpr double kFarAway_m = 10.0;  // clearance if no robot is near

}  // namespace

double lane_clearance_m(const Vec2& from_m, const Vec2& to_m, const TrackedRobots& robots) {
  double least2 = kFarAway_m * kFarAway_m;
  for (const TrackedRobot& robot : robots) {
    const Vec2 near_m = nearest_on_segment(robot.position_m, from_m, to_m);
    least2 = std::min(least2, (robot.position_m - near_m).squaredNorm());
  }
  return std::sqrt(least2);
}

Aim best_shot(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents) {
  const double reach_m = field.half_goal_m() - 2.5 * kBallRadius_m;
  Aim best;
  double best_score = -1e9;
  for (int i = 0; i < kAimPoints; ++i) {
    const double share = 2.0 * i / (kAimPoints - 1) - 1.0;
    const Vec2 target_m(field.half_length_m(), share * reach_m);
    const double clearance_m = lane_clearance_m(ball_m, target_m, opponents);
    // More space than a robot's and a ball's radius helps little; then the middle is safer.
    const double score = std::min(clearance_m, 0.25) - 0.02 * std::abs(share);
    if (score > best_score) {
      best_score = score;
      best = {target_m, clearance_m};
    }
  }
  return best;
}

Aim best_push(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents) {
  const Vec2 ahead = direction_of(field.goal_centre_m(Side::kEast) - ball_m, Vec2(1, 0));
  Aim best;
  double best_score = -1e9;
  for (int i = -kPushSteps; i <= kPushSteps; ++i) {
    const double turn_rad = kWidestPush_rad * i / kPushSteps;
    const Vec2 target_m = ball_m + kPush_m * to_world(heading_of(turn_rad), ahead);
    const double clearance_m = lane_clearance_m(ball_m, target_m, opponents);
    const double score = std::min(clearance_m, 0.4) - 0.1 * std::abs(turn_rad) -
                         (is_on_field(field, target_m) ? 0.0 : 0.3);
    if (score > best_score) {
      best_score = score;
      best = {target_m, clearance_m};
    }
  }
  return best;
}

}  // namespace autoref::strategies
