#include "soccer/geometry.hpp"

#include <algorithm>

#include "soccer/trigonometry.hpp"

namespace autoref {

Vec2 direction_of(const Vec2& v, const Vec2& otherwise) {
  const double length = v.norm();
  return length < 1e-9 ? otherwise : Vec2(v / length);
}

Vec2 clamp_norm(const Vec2& v, double limit) {
  const double length = v.norm();
  return length <= limit ? v : Vec2(v * (limit / length));
}

Vec2 heading_of(double angle_rad) {
  const auto [s, c] = sin_cos(angle_rad);
  return {c, s};
}

double angle_of(const Vec2& v) { return atan2_exact(v.y(), v.x()); }

double angle_between(const Vec2& from, const Vec2& to) {
  return atan2_exact(cross(from, to), from.dot(to));
}

Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double length2 = ab.squaredNorm();
  if (length2 == 0.0) return a;
  return a + ab * std::clamp((p - a).dot(ab) / length2, 0.0, 1.0);
}

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  return (p - nearest_on_segment(p, a, b)).norm();
}

}  // namespace autoref
