#include "judge/truth/crossing.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::judge::ground_truth {
namespace {

// Fraction of the step at which a coordinate reaches +-limit; nullopt if it does not.
std::optional<double> share_at(double from, double to, double limit) {
  if (std::abs(to) <= limit) return std::nullopt;
  const double line = std::copysign(limit, to);
  return from == to ? 0.0 : std::clamp((line - from) / (to - from), 0.0, 1.0);
}

}  // namespace

double inside_m(const Field& field, const Vec2& ball_m) {
  return std::min(field.half_length_m() - std::abs(ball_m.x()),
                  field.half_width_m() - std::abs(ball_m.y())) +
         kBallRadius_m;
}

std::optional<Crossing> find_crossing(const Field& field, const sim::BallState& before,
                                      const sim::BallState& now) {
  if (inside_m(field, now.position_m) >= 0 || inside_m(field, before.position_m) < 0) {
    return std::nullopt;
  }
  const Vec2& a = before.position_m;
  const Vec2& b = now.position_m;
  const auto goal = share_at(a.x(), b.x(), field.half_length_m() + kBallRadius_m);
  const auto touch = share_at(a.y(), b.y(), field.half_width_m() + kBallRadius_m);
  Crossing crossing;
  // The ball leaves over the line it reaches first on the straight path between the two frames.
  crossing.over_goal_line = goal && (!touch || *goal <= *touch);
  crossing.share = crossing.over_goal_line ? *goal : *touch;
  crossing.point_m = a + crossing.share * (b - a);
  crossing.height_m = before.height_m + crossing.share * (now.height_m - before.height_m);
  crossing.end = crossing.point_m.x() < 0 ? Side::kWest : Side::kEast;
  crossing.into_goal = crossing.over_goal_line &&
                       std::abs(crossing.point_m.y()) < field.half_goal_m() &&
                       crossing.height_m + kBallRadius_m < field.goal_opening_height_m;
  return crossing;
}

}  // namespace autoref::judge::ground_truth
