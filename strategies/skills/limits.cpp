#include "strategies/skills/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::strategies {
namespace {

// Robots this near to each other count as being in contact, directly or through a ball between
// them.
constexpr double kContact_m = 35_mm;

constexpr double kFarMargin_m = 1e-6;  // far above rounding errors
// The 500 mm from the ball that the Laws require, and a hull.
constexpr double kWideRunOff_m = 600_mm;
constexpr int kTurns = 36;  // directions tried on each side of a position inside the ball's circle

// Moves `p` to the nearest point at `distance_m` from the area of `side`.
//
// A defence area of either shape is the set of points within a radius of a strip that continues
// behind the goal. For a box, the radius is zero.
Vec2 pushed_out_of_area(const Field& field, Side side, const Vec2& p, double distance_m,
                        bool may_stay_behind_goal) {
  // The point is in front of the area's front line by more than the distance.
  const double ahead_m = field.half_length_m() - goal_sign(side) * p.x();
  if (ahead_m > field.defence_area.depth_m + distance_m + kFarMargin_m) return p;
  const double missing_m = distance_m - distance_to_defence_area(field, side, p);
  if (missing_m <= 0) return p;
  const DefenceArea& area = field.defence_area;
  const bool is_box = area.shape == DefenceArea::Shape::kBox;
  const double half_m = area.straight_m / 2;
  const double radius_m = is_box ? 0.0 : area.depth_m;
  const Vec2 ahead(-goal_sign(side), 0);
  const Vec2 end_m = field.goal_centre_m(side) + ahead * (area.depth_m - radius_m);
  const double beyond_end_m = (p - end_m).dot(ahead);
  if (beyond_end_m >= 0 || (may_stay_behind_goal && !is_box)) {
    const Vec2 nearest_m = end_m + Vec2(0, std::clamp(p.y(), -half_m, half_m));
    return p + direction_of(p - nearest_m, ahead) * missing_m;
  }
  const double to_front_m = radius_m + distance_m - beyond_end_m;
  const double to_side_m = half_m + radius_m + distance_m - std::abs(p.y());
  if (to_front_m <= to_side_m) return p + ahead * to_front_m;
  return p + Vec2(0, std::copysign(to_side_m, p.y()));
}

Vec2 back_from(const Field& field, const Vec2& ball_m) {
  return direction_of(field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
}

Vec2 pushed_off_ball(const Field& field, const Vec2& p, const Vec2& ball_m, const Limits& limits) {
  if (limits.keep_from_ball_m <= 0 || (p - ball_m).norm() >= limits.keep_from_ball_m) return p;
  // Moves the position towards the team's own goal, where a robot that must give way is most
  // useful.
  const Vec2 back = back_from(field, ball_m);
  const Vec2 away = direction_of(p - ball_m, back);
  const Vec2 bent = away.dot(back) < 0 ? direction_of(away + 1.5 * back, back) : away;
  return ball_m + bent * (limits.keep_from_ball_m + kLimitMargin_m);
}

// Applies the limits that do not depend on the ball: those from the own half, the areas and the
// field.
Vec2 pushed_into_bounds(const Field& field, Vec2 p, const Limits& limits) {
  if (limits.own_half_only) p.x() = std::min(p.x(), -kRobotRadius_m - kLimitMargin_m);
  if (!limits.may_enter_own_area) {
    p = pushed_out_of_area(field, Side::kWest, p, kRobotRadius_m + limits.own_area_margin_m,
                           limits.may_stay_behind_goal);
  }
  if (limits.keep_from_area_m > 0) {
    p = pushed_out_of_area(field, Side::kEast, p, limits.keep_from_area_m + kLimitMargin_m,
                           limits.may_stay_behind_goal);
  }
  const Vec2 farthest_m = farthest_between_walls_m(field);
  const double x_m = std::min(field.half_length_m() + limits.beyond_lines_m, farthest_m.x());
  const double y_m = std::min(field.half_width_m() + limits.beyond_lines_m, farthest_m.y());
  return {std::clamp(p.x(), -x_m, x_m), std::clamp(p.y(), -y_m, y_m)};
}

}  // namespace

void ease_off(const TrackedRobot& robot, const TrackedRobots& opponents, const Easing& easing,
              RobotCommand& command) {
  Vec2 velocity_mps = to_world(command.velocity_mps, robot.heading);
  for (const TrackedRobot& opponent : opponents) {
    const Vec2 there = opponent.position_m - robot.position_m;
    const double gap_m = there.norm() - 2 * kRobotRadius_m;
    if (gap_m > easing.from_m) continue;
    const Vec2 direction = direction_of(there, Vec2(1, 0));
    const double most_mps =
        easing.gentle_mps + std::sqrt(2 * easing.braking_mps2 * std::max(0.0, gap_m));
    const double closing_mps = (velocity_mps - opponent.velocity_mps).dot(direction);
    if (closing_mps > most_mps) velocity_mps -= direction * (closing_mps - most_mps);
    if (gap_m > kContact_m) continue;
    const double pressing_mps = velocity_mps.dot(direction) - easing.contact_mps;
    if (pressing_mps > 0) velocity_mps -= direction * pressing_mps;
  }
  command.velocity_mps = to_local(velocity_mps, robot.heading);
}

Vec2 farthest_between_walls_m(const Field& field) {
  constexpr double kAnywhere_m = std::numeric_limits<double>::infinity();
  if (field.run_off_m >= kWideRunOff_m) return {kAnywhere_m, kAnywhere_m};
  return {field.wall_x_m() - kRobotRadius_m, field.wall_y_m() - kRobotRadius_m};
}

Vec2 off_walls(const Field& field, const Vec2& from_m, const Vec2& direction, double length_m) {
  const Vec2 farthest_m = farthest_between_walls_m(field);
  for (int i = 0; i <= kTurns; ++i) {
    for (const double side : {1.0, -1.0}) {
      const Vec2 turned = to_world(direction, heading_of(side * i * kPi / kTurns));
      const Vec2 to_m = from_m + length_m * turned;
      if (std::abs(to_m.x()) <= farthest_m.x() && std::abs(to_m.y()) <= farthest_m.y())
        return i == 0 ? direction : turned;
    }
  }
  return direction;
}

double room_for_error_m(const RuleBook& rules) {
  return rules.edition == Edition::kRules2026 ? 40_mm : 0.0;
}

Vec2 permitted(const Field& field, const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits) {
  return pushed_into_bounds(field, pushed_off_ball(field, wanted_m, ball_m, limits), limits);
}

Vec2 permitted_by_all(const Field& field, const Vec2& wanted_m, const Vec2& ball_m,
                      const Limits& limits) {
  Vec2 p = permitted(field, wanted_m, ball_m, limits);
  if ((p - ball_m).norm() >= limits.keep_from_ball_m) return p;
  const Vec2 off_m = direction_of(p - ball_m, back_from(field, ball_m)) *
                     (limits.keep_from_ball_m + kLimitMargin_m);
  // Searches the circle around the ball at increasing angles to both sides, so the first permitted
  // position found is the nearest one.
  for (int i = 1; i <= kTurns; ++i) {
    for (const double side : {1.0, -1.0}) {
      Vec2 turned_m = ball_m + to_world(off_m, heading_of(side * i * kPi / kTurns));
      if (pushed_into_bounds(field, turned_m, limits) == turned_m) return turned_m;
    }
  }
  return p;
}

}  // namespace autoref::strategies
