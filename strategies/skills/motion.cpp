#include "strategies/skills/motion.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::strategies {
namespace {

constexpr double kMotionLookAhead_m = 1.5;  // obstacles farther along the path are ignored
constexpr double kBetween = 0.7;            // minimum cosine between a wall's and a robot's
                                            // direction
constexpr double kGoalClearance_m = 30_mm;  // gap between a goal's wall and a passing robot

// The first obstacle on the path from `from_m` along the unit vector `direction`; nullptr if there
// is none.
const Obstacle* first_on_path(const Vec2& from_m, const Vec2& direction, double length_m,
                              const Obstacles& obstacles) {
  const Obstacle* first = nullptr;
  double first_along_m = std::min(length_m, kMotionLookAhead_m);
  for (const Obstacle& obstacle : obstacles) {
    const Vec2 offset = obstacle.position_m - from_m;
    const double along_m = offset.dot(direction);
    if (along_m <= 0 || along_m >= first_along_m) continue;
    if (std::abs(cross(direction, offset)) >= obstacle.clearance_m) continue;
    first = &obstacle;
    first_along_m = along_m;
  }
  return first;
}

constexpr double kAvoidanceLookAhead_m = 1.6;  // obstacles farther along the path are ignored
constexpr double kMovesOn_s = 0.25;            // other robots are extrapolated by this time
constexpr double kRoom_m = 30_mm;              // gap between hulls
constexpr double kAvoidanceBeside_m = 20_mm;   // additional clearance of the detour point
constexpr double kBlockedLeg_m = 0.5;          // length added to a detour if an obstacle is on it
constexpr double kBehindWall_m = 20;           // length added to a detour if a wall is on it
constexpr double kTurning_s = 0.15;  // weight of the current velocity, as path length per speed

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

bool Obstacles::has_room(const Obstacle& obstacle, const Vec2& from_m, const Vec2& beside_m) const {
  if (inside_walls_m(beside_m) == beside_m) return true;
  const Vec2 off_m = from_m - obstacle.position_m;
  const Vec2 beside = beside_m - obstacle.position_m;
  return off_m.norm() < obstacle.clearance_m &&
         off_m.dot(beside) > kBetween * off_m.norm() * beside.norm();
}

Vec2 steer_around(const Vec2& from_m, const Vec2& target_m, const Obstacles& obstacles) {
  const Vec2 offset = target_m - from_m;
  const double length_m = offset.norm();
  if (length_m < 1e-6) return target_m;
  const Vec2 direction = offset / length_m;
  const Obstacle* obstacle = first_on_path(from_m, direction, length_m, obstacles);
  if (obstacle == nullptr) return target_m;
  // Passes the obstacle on the side on which the straight path runs.
  const double side = cross(direction, obstacle->position_m - from_m) > 0 ? -1.0 : 1.0;
  const Vec2 beside = left_of(direction) * (side * obstacle->clearance_m * 1.1);
  const Vec2 beside_m = obstacle->position_m + beside;
  return obstacles.has_room(*obstacle, from_m, beside_m) ? obstacles.inside_walls_m(beside_m)
                                                         : Vec2(obstacle->position_m - beside);
}

std::optional<Vec2> exit_from_behind_goal(const Field& field, const Vec2& from_m) {
  const double beyond_m = std::abs(from_m.x()) - field.half_length_m();
  const double flank_m = field.half_goal_m() + field.goal_wall_thickness_m + kRobotRadius_m;
  const double aside_m = std::abs(from_m.y());
  if (beyond_m <= 0 || aside_m > flank_m + kGoalClearance_m) return std::nullopt;
  if (aside_m >= flank_m) {
    const double before_line_m = field.half_length_m() - kRobotRadius_m;
    return Vec2(std::copysign(before_line_m, from_m.x()), from_m.y());
  }
  const bool is_in_goal = beyond_m < field.goal_depth_m + kRobotRadius_m;
  if (is_in_goal || field.goal_sides_reach_wall) return std::nullopt;
  return Vec2(from_m.x(), std::copysign(flank_m + kGoalClearance_m, from_m.y()));
}

RobotCommand drive_with(const TrackedRobot& robot, const Vec2& velocity_mps, const Vec2& heading,
                        const DrivingStyle& style) {
  RobotCommand command;
  command.velocity_mps = to_local(velocity_mps, robot.heading);
  const double error_rad = angle_between(robot.heading, heading);
  // The time-optimal braking curve is sqrt(2 a e) for an error e. Near the target, a proportional
  // controller replaces it, because the curve's slope is unbounded there.
  const double rate_radps =
      std::min({style.turn_per_s * std::abs(error_rad), style.turn_limit_radps,
                std::sqrt(2 * style.turn_braking_radps2 * std::abs(error_rad))});
  command.angular_velocity_radps = std::copysign(rate_radps, error_rad);
  return command;
}

RobotCommand drive_via(const TrackedRobot& robot, const Vec2& steer_m, const Waypoint& goal,
                       const DrivingStyle& style) {
  const double left_m = (goal.position_m - robot.position_m).norm();
  if (left_m < style.arrived_m) return drive_with(robot, Vec2(0, 0), goal.heading, style);
  const Vec2 direction = direction_of(steer_m - robot.position_m, goal.heading);
  // Along the path, the speed follows the same braking curve, with the same proportional controller
  // near the target.
  const double speed_mps = std::min(
      {style.speed_mps, style.approach_per_s * left_m, std::sqrt(2 * style.braking_mps2 * left_m)});
  return drive_with(robot, direction * speed_mps, goal.heading, style);
}

RobotCommand drive_to(const TrackedRobot& robot, const Waypoint& goal, const Obstacles& obstacles,
                      const DrivingStyle& style) {
  return drive_via(robot, steer_around(robot.position_m, goal.position_m, obstacles), goal, style);
}

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
    // Favours the side towards which the robot is already moving, so that the choice does not flip.
    cost_m -= kTurning_s * robot.velocity_mps.dot(direction_of(leg, direction));
    if (cost_m >= best_cost_m) continue;
    best_cost_m = cost_m;
    best_m = obstacles.inside_walls_m(beside_m);
  }
  return best_m;
}

}  // namespace autoref::strategies
