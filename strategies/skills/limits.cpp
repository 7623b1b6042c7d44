#include "strategies/skills/limits.hpp"

#include <algorithm>

#include "soccer/robot_shape.hpp"

namespace autoref::strategies {
namespace {

constexpr double kMargin_m = 30_mm;  // more than a rule asks for, for the robots' own errors

// Moves `p` straight away from the area's middle until it is `distance_m` off the area of `side`.
Vec2 pushed_out_of_area(const Field& field, Side side, const Vec2& p, double distance_m) {
  const double missing_m = distance_m - distance_to_defence_area(field, side, p);
  if (missing_m <= 0) return p;
  const Vec2 inwards(-goal_sign(side), 0);
  const Vec2 corner_m =
      field.goal_centre_m(side) + Vec2(0, std::clamp(p.y(), -field.defence_area.straight_m / 2,
                                                     field.defence_area.straight_m / 2));
  return p + direction_of(p - corner_m, inwards) * missing_m;
}

}  // namespace

Vec2 permitted(const Field& field, const Vec2& wanted_m, const Vec2& ball_m, const Limits& limits) {
  Vec2 p = wanted_m;
  if (limits.keep_from_ball_m > 0 && (p - ball_m).norm() < limits.keep_from_ball_m) {
    // Towards the own goal, where a robot that must give way is of most use.
    const Vec2 back = direction_of(field.goal_centre_m(Side::kWest) - ball_m, Vec2(-1, 0));
    const Vec2 away = direction_of(p - ball_m, back);
    const Vec2 bent = away.dot(back) < 0 ? direction_of(away + 1.5 * back, back) : away;
    p = ball_m + bent * (limits.keep_from_ball_m + kMargin_m);
  }
  if (limits.own_half_only) p.x() = std::min(p.x(), -kRobotRadius_m - kMargin_m);
  if (!limits.may_enter_own_area) {
    p = pushed_out_of_area(field, Side::kWest, p, kRobotRadius_m + kMargin_m);
  }
  if (limits.keep_from_area_m > 0) {
    p = pushed_out_of_area(field, Side::kEast, p, limits.keep_from_area_m + kMargin_m);
  }
  const double x_m = field.half_length_m() + limits.beyond_lines_m;
  const double y_m = field.half_width_m() + limits.beyond_lines_m;
  return {std::clamp(p.x(), -x_m, x_m), std::clamp(p.y(), -y_m, y_m)};
}

}  // namespace autoref::strategies
