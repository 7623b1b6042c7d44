// Plane geometry: x to the east, y to the north, angles counterclockwise.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "soccer/trigonometry.hpp"

namespace autoref {

using Vec2 = Eigen::Vector2d;

inline double square(double x) { return x * x; }

// `v` rotated left by 90 degrees.
inline Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

// z component of the cross product; positive if `b` points to the left of `a`.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Rotates `v` from the frame whose x axis is the unit vector `heading` into the world frame.
inline Vec2 to_world(const Vec2& v, const Vec2& heading) {
  return {v.x() * heading.x() - v.y() * heading.y(), v.x() * heading.y() + v.y() * heading.x()};
}

// Inverse of to_world: the components of `v` along the unit vector `heading` and to the left of it.
inline Vec2 to_local(const Vec2& v, const Vec2& heading) {
  return {v.x() * heading.x() + v.y() * heading.y(), -v.x() * heading.y() + v.y() * heading.x()};
}

// Unit vector along `v`, or `otherwise` if `v` is shorter than 1e-9.
inline Vec2 direction_of(const Vec2& v, const Vec2& otherwise) {
  const double length = v.norm();
  return length < 1e-9 ? otherwise : Vec2(v / length);
}

// `v`, scaled down to length `limit` if it is longer.
inline Vec2 clamp_norm(const Vec2& v, double limit) {
  const double length2 = v.squaredNorm();
  return length2 <= limit * limit ? v : Vec2(v * (limit / std::sqrt(length2)));
}

// Converts an angle to a unit vector, and back.
inline Vec2 heading_of(double angle_rad) {
  const auto [s, c] = sin_cos(angle_rad);
  return {c, s};
}
double angle_of(const Vec2& v);

// The signed angle from `from` to `to`, in [-pi, pi].
double angle_between(const Vec2& from, const Vec2& to);

// The point of the segment a-b nearest to `p`; `a` if the segment is a single point.
inline Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 ab = b - a;
  const double length2 = ab.squaredNorm();
  if (length2 == 0.0) return a;
  return a + ab * std::clamp((p - a).dot(ab) / length2, 0.0, 1.0);
}

inline double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  return (p - nearest_on_segment(p, a, b)).norm();
}

inline bool is_finite(const Vec2& v) { return v.allFinite(); }

}  // namespace autoref
