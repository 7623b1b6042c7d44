#include "soccer/geometry.hpp"

#include "soccer/trigonometry.hpp"

namespace autoref {

double angle_of(const Vec2& v) { return atan2_exact(v.y(), v.x()); }

double angle_between(const Vec2& from, const Vec2& to) {
  return atan2_exact(cross(from, to), from.dot(to));
}

}  // namespace autoref
