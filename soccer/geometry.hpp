// Plane geometry: x to the east, y to the north, angles counterclockwise.
#pragma once

#include <Eigen/Core>

namespace autoref {

using Vec2 = Eigen::Vector2d;

// The vector turned left by 90 degrees.
inline Vec2 left_of(const Vec2& v) { return {-v.y(), v.x()}; }

// z of the cross product; positive when `b` points to the left of `a`.
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// `v`, given along and to the left of the unit vector `heading`, in the frame of `heading`.
inline Vec2 to_world(const Vec2& v, const Vec2& heading) {
  return {v.x() * heading.x() - v.y() * heading.y(), v.x() * heading.y() + v.y() * heading.x()};
}

// The parts of `v` along and to the left of the unit vector `heading`: to_world's inverse.
inline Vec2 to_local(const Vec2& v, const Vec2& heading) {
  return {v.x() * heading.x() + v.y() * heading.y(), -v.x() * heading.y() + v.y() * heading.x()};
}

// Unit vector along `v`, or `otherwise` where `v` is shorter than 1e-9.
Vec2 direction_of(const Vec2& v, const Vec2& otherwise);

// `v`, shortened to `limit` where it is longer.
Vec2 clamp_norm(const Vec2& v, double limit);

// Unit vector at `angle_rad`, and back.
Vec2 heading_of(double angle_rad);
double angle_of(const Vec2& v);

// The angle in [-pi, pi] that turns `from` into the direction of `to`.
double angle_between(const Vec2& from, const Vec2& to);

// The point of the segment a-b nearest to `p`; `a` where the segment is a point.
Vec2 nearest_on_segment(const Vec2& p, const Vec2& a, const Vec2& b);
double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b);

inline bool is_finite(const Vec2& v) { return v.allFinite(); }

}  // namespace autoref
