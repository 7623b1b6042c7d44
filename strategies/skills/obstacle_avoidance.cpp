#include "strategies/skills/obstacle_avoidance.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies {
namespace {

constexpr double kAvoidanceLookAhead_m = 1.6;  // obstacles farther along the path are ignored
constexpr double kMovesOn_s = 0.25;            // other robots are extrapolated by this time
constexpr double kRoom_m = 30_mm;              // between hulls
constexpr double kAvoidanceBeside_m = 20_mm;   // additional clearance of the detour point
constexpr double kBlockedLeg_m = 0.5;          // length added to a detour if an obstacle is on it
constexpr double kBehindWall_m = 20;           // the same if a wall is
constexpr double kTurning_s = 0.15;            // weight of the current velocity: length per speed

// The first obstacle on the segment; nullptr if there is none.
const Obstacle* first_on(const Vec2& from_m, const Vec2& to_m, const Obstacles& obstacles) {
  const Vec2 offset = to_m - from_m;
  const double length_m = offset.norm();
  if (length_m < 1e-6) return nullptr;
  const Vec2 direction = offset / length_m;
  const Obstacle* first = nullptr;
  double first_m = std::min(length_m, kAvoidanceLookAhead_m);
  for (const Obstacle& obstacle : obstacles) {
    const Vec2 there = obstacle.position_m - from_m;
    const double along_m = there.dot(direction);
    if (along_m <= 0 || along_m >= first_m) continue;
    if (std::abs(cross(direction, there)) >= obstacle.clearance_m) continue;
    first = &obstacle;
    first_m = along_m;
  }
  return first;
}

}  // namespace

void find_obstacles(const Surroundings& all, const TrackedRobot& robot, const Vec2& target_m,
                    Obstacles& obstacles) {
  obstacles.clear();
  obstacles.farthest_m = all.farthest_m;
  const Vec2 middle_m = (robot.position_m + target_m) / 2;
  const double reach_m = (target_m - robot.position_m).norm() / 2 + 4 * kRobotRadius_m;
  const auto add = [&](const TrackedRobot& other) {
    const Vec2 there_m = other.position_m + other.velocity_mps * kMovesOn_s;
    if ((there_m - middle_m).squaredNorm() > reach_m * reach_m) return;
    // If the target is right beside the other robot, only that robot's hull is avoided.
    const double to_target_m = (target_m - there_m).norm();
    const double clearance_m = 2 * kRobotRadius_m + kRoom_m;
    if (to_target_m > 2 * kRobotRadius_m || to_target_m > (robot.position_m - there_m).norm())
      obstacles.push_back(
          {there_m, std::min(clearance_m, std::max(to_target_m, 2 * kRobotRadius_m))});
  };
  for (const TrackedRobot& mate : all.own) {
    if (mate.number != robot.number) add(mate);
  }
  for (const TrackedRobot& opponent : all.opponents) add(opponent);
  if (all.ball_room_m > 0) obstacles.push_back({all.ball_m, all.ball_room_m + kRobotRadius_m});
}

Vec2 steer_for(const TrackedRobot& robot, const Vec2& target_m, const Obstacles& obstacles) {
  const Vec2& from_m = robot.position_m;
  const Obstacle* hit = first_on(from_m, target_m, obstacles);
  if (hit == nullptr) return target_m;
  const Vec2 direction = direction_of(target_m - from_m, Vec2(1, 0));
  Vec2 best_m = target_m;
  double best_cost_m = 1e9;
  for (const double side : {1.0, -1.0}) {
    const Vec2 beside_m =
        hit->position_m + left_of(direction) * (side * (hit->clearance_m + kAvoidanceBeside_m));
    const Vec2 leg = beside_m - from_m;
    double cost_m = leg.norm() + (target_m - beside_m).norm();
    if (const Obstacle* next = first_on(from_m, beside_m, obstacles);
        next != nullptr && next != hit)
      cost_m += kBlockedLeg_m;
    if (first_on(beside_m, target_m, obstacles) != nullptr) cost_m += kBlockedLeg_m / 2;
    if (!obstacles.has_room(*hit, from_m, beside_m)) cost_m += kBehindWall_m;
    // Favours the side to which the robot already moves, so the choice does not flip.
    cost_m -= kTurning_s * robot.velocity_mps.dot(direction_of(leg, direction));
    if (cost_m >= best_cost_m) continue;
    best_cost_m = cost_m;
    best_m = obstacles.inside_walls_m(beside_m);
  }
  return best_m;
}

}  // namespace autoref::strategies
