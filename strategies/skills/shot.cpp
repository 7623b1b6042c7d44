#include "strategies/skills/shot.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "soccer/robot_shape.hpp"
#include "strategies/skills/lane.hpp"

namespace autoref::strategies {
namespace {

constexpr int kAimPoints = 9;
constexpr int kPushSteps = 3;  // directions to each side of straight ahead
constexpr double kWidestPush_rad = 90_deg;
constexpr double kPush_m = 1.0;
constexpr double kFarAway_m = 10.0;    // clearance if no robot is near
constexpr double kScoreMargin = 1e-9;  // far above rounding errors

// Like lane_clearance_m if that is at least `needed_m`; otherwise some value between the two.
double clearance_if_m(double needed_m, const Vec2& from_m, const Vec2& to_m,
                      const TrackedRobots& robots) {
  const double needed2 = square(std::max(0.0, needed_m));
  double least2 = kFarAway_m * kFarAway_m;
  const Lane lane(from_m, to_m);
  for (const TrackedRobot& robot : robots) {
    if (lane.is_beyond(robot.position_m, least2)) continue;
    const Vec2 near_m = lane.nearest_m(robot.position_m);
    least2 = std::min(least2, (robot.position_m - near_m).squaredNorm());
    if (least2 < needed2) break;
  }
  return std::sqrt(least2);
}

// The directions of a push, relative to straight ahead: `turn_rad` and its unit vector.
struct PushDirection {
  double turn_rad;
  Vec2 heading;
};
std::array<PushDirection, 2 * kPushSteps + 1> push_directions() {
  std::array<PushDirection, 2 * kPushSteps + 1> all;
  int step = -kPushSteps;
  for (PushDirection& direction : all) {
    const double turn_rad = kWidestPush_rad * step++ / kPushSteps;
    direction = {turn_rad, heading_of(turn_rad)};
  }
  return all;
}

}  // namespace

double lane_clearance_m(const Vec2& from_m, const Vec2& to_m, const TrackedRobots& robots) {
  return clearance_if_m(0, from_m, to_m, robots);
}

Aim best_shot(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents) {
  const double reach_m = field.half_goal_m() - 2.5 * kBallRadius_m;
  Aim best;
  double best_score = -1e9;
  for (int i = 0; i < kAimPoints; ++i) {
    const double share = 2.0 * i / (kAimPoints - 1) - 1.0;
    const Vec2 target_m(field.half_length_m(), share * reach_m);
    // More space than a robot's and a ball's radius helps little; then the middle is safer.
    const double aside_cost = 0.02 * std::abs(share);
    const double needed_m = best_score + aside_cost - kScoreMargin;
    const double clearance_m = clearance_if_m(needed_m, ball_m, target_m, opponents);
    const double score = std::min(clearance_m, 0.25) - aside_cost;
    if (score > best_score) {
      best_score = score;
      best = {target_m, clearance_m};
    }
  }
  return best;
}

Aim best_push(const Field& field, const Vec2& ball_m, const TrackedRobots& opponents) {
  static const std::array kDirections = push_directions();
  const Vec2 ahead = direction_of(field.goal_centre_m(Side::kEast) - ball_m, Vec2(1, 0));
  Aim best;
  double best_score = -1e9;
  for (const PushDirection& push : kDirections) {
    const Vec2 target_m = ball_m + kPush_m * to_world(push.heading, ahead);
    const double turning_cost = 0.1 * std::abs(push.turn_rad);
    const double needed_m = best_score + turning_cost - kScoreMargin;
    const double clearance_m = clearance_if_m(needed_m, ball_m, target_m, opponents);
    const double score =
        std::min(clearance_m, 0.4) - turning_cost - (is_on_field(field, target_m) ? 0.0 : 0.3);
    if (score > best_score) {
      best_score = score;
      best = {target_m, clearance_m};
    }
  }
  return best;
}

}  // namespace autoref::strategies
