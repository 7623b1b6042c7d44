#include "soccer/geometry.hpp"

#include "soccer/trigonometry.hpp"

namespace autoref {

Vec2 heading_of(double angle_rad) {
  const auto [s, c] = sin_cos(angle_rad);
  return {c, s};
}

double angle_of(const Vec2& v) { return atan2_exact(v.y(), v.x()); }

double angle_between(const Vec2& from, const Vec2& to) {
  return atan2_exact(cross(from, to), from.dot(to));
}

}  // namespace autoref
