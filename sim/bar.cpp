#include "sim/bar.hpp"

#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::sim {
namespace {

// Segment-circle intersection: the first fraction of the segment from `from_m` to `to_m` at which
// the distance to the origin is `near_m`.
std::optional<double> collision(const Vec2& from_m, const Vec2& to_m, double near_m) {
  const Vec2 path_m = to_m - from_m;
  const double towards = -from_m.dot(path_m);
  const double spare = from_m.squaredNorm() - near_m * near_m;
  if (towards <= 0.0) return std::nullopt;
  if (spare <= 0.0) return 0.0;
  const double length2 = path_m.squaredNorm();
  const double root2 = towards * towards - length2 * spare;
  if (root2 < 0.0) return std::nullopt;
  const double share = (towards - std::sqrt(root2)) / length2;
  return share <= 1.0 ? std::optional(share) : std::nullopt;
}

}  // namespace

std::optional<BallState> bounced_off_bar(const Field& field, double restitution,
                                         const BallState& former, const BallState& now) {
  if (std::abs(now.position_m.y()) > field.half_goal_m()) return std::nullopt;
  // Side view along the bar: x as on the field, then the height.
  const Vec2 bar_m(
      std::copysign(field.half_length_m() + field.goal_bar_radius_m, now.position_m.x()),
      field.goal_opening_height_m + field.goal_bar_radius_m);
  const auto from_bar_m = [&bar_m](const BallState& ball) {
    return Vec2(Vec2(ball.position_m.x(), ball.height_m + kBallRadius_m) - bar_m);
  };
  const std::optional<double> share =
      collision(from_bar_m(former), from_bar_m(now), kBallRadius_m + field.goal_bar_radius_m);
  if (!share) return std::nullopt;
  BallState met = now;
  met.position_m = former.position_m + *share * (now.position_m - former.position_m);
  met.height_m = former.height_m + *share * (now.height_m - former.height_m);
  const Vec2 outwards = from_bar_m(met).normalized();
  const double closing_mps = -Vec2(now.velocity_mps.x(), now.vertical_mps).dot(outwards);
  if (closing_mps <= 0.0) return std::nullopt;
  // Newton's law of restitution along the line of centres, without friction.
  met.velocity_mps.x() += (1.0 + restitution) * closing_mps * outwards.x();
  met.vertical_mps += (1.0 + restitution) * closing_mps * outwards.y();
  return met;
}

}  // namespace autoref::sim
