#include "referee/geometry/ball_out.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// The corner of the expanded field nearest to the ball: the paper's (l_x, l_y).
Vec2 nearest_corner(const Field& field, const Vec2& ball_m) {
  return {std::copysign(field.half_length_m() + kBallRadius_m, ball_m.x()),
          std::copysign(field.half_width_m() + kBallRadius_m, ball_m.y())};
}

double beyond_m(double ball, double line) { return std::abs(ball) - std::abs(line); }

double clamped(double value, double limit) {
  return std::clamp(value, -std::abs(limit), std::abs(limit));
}

// The exit of a ball that was already out in the previous frame: the ball counts as having crossed
// the boundary that it is farther beyond.
Exit exit_of_ball_out_before(const Vec2& l, const Vec2& b) {
  if (beyond_m(b.y(), l.y()) > beyond_m(b.x(), l.x())) {
    return {ExitLine::kTouch, {clamped(b.x(), l.x()), l.y()}};
  }
  return {ExitLine::kGoal, {l.x(), clamped(b.y(), l.y())}};
}

}  // namespace

bool is_out_of_field(const Field& field, const Vec2& ball_m) {
  return std::abs(ball_m.x()) > kBallRadius_m + field.half_length_m() ||
         std::abs(ball_m.y()) > kBallRadius_m + field.half_width_m();
}

std::optional<double> intersection(double along0, double across0, double along1, double across1,
                                   double at) {
  if (along0 == along1) return std::nullopt;
  // Linear interpolation between the two points, or extrapolation beyond them.
  return (across0 * (at - along1) + across1 * (along0 - at)) / (along0 - along1);
}

Exit find_exit(const Field& field, const Vec2& before_m, const Vec2& ball_m) {
  const Vec2 l = nearest_corner(field, ball_m);
  if (is_out_of_field(field, before_m)) return exit_of_ball_out_before(l, ball_m);
  // Deviation D8: if the ball is not beyond a boundary, it has not crossed it, no matter where the
  // extended line of its path intersects it.
  const bool beyond_touch = beyond_m(ball_m.y(), l.y()) > 0;
  const bool beyond_goal = beyond_m(ball_m.x(), l.x()) > 0;
  const std::optional<double> c_x =
      intersection(before_m.y(), before_m.x(), ball_m.y(), ball_m.x(), l.y());
  const std::optional<double> c_y =
      intersection(before_m.x(), before_m.y(), ball_m.x(), ball_m.y(), l.x());
  const bool over_touch =
      beyond_touch && (!beyond_goal || (c_x && std::abs(*c_x) < std::abs(l.x())));
  if (over_touch) return {ExitLine::kTouch, {clamped(c_x.value_or(ball_m.x()), l.x()), l.y()}};
  return {ExitLine::kGoal, {l.x(), clamped(c_y.value_or(ball_m.y()), l.y())}};
}

bool is_in_goal(const Field& field, const Vec2& ball_m, double height_m) {
  return std::abs(ball_m.x()) > field.half_length_m() + kBallRadius_m &&
         std::abs(ball_m.y()) < field.half_goal_m() &&
         height_m + kBallRadius_m < field.goal_opening_height_m;
}

}  // namespace autoref::referee
