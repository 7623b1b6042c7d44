#include "soccer/field.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref {

// A signed distance, negative inside. The quarter-circle area is half a capsule: the points within
// a radius of its straight part. For the box, it is the distance to the nearer edge or, from a
// point beyond both edges, to the corner. Points behind the goal line count as being on it.
double distance_to_defence_area(const Field& field, Side side, const Vec2& point_m) {
  const DefenceArea& area = field.defence_area;
  // Depth into the field from the goal line, and lateral distance from the goal's centre.
  const double x = std::max(0.0, field.half_length_m() - goal_sign(side) * point_m.x());
  const double y = std::abs(point_m.y());
  if (area.shape == DefenceArea::Shape::kQuarterCircles) {
    const double beyond = std::max(0.0, y - area.straight_m / 2);
    return std::sqrt(x * x + beyond * beyond) - area.depth_m;
  }
  const double dx = x - area.depth_m;
  const double dy = y - area.straight_m / 2;
  if (dx <= 0.0 || dy <= 0.0) return std::max(dx, dy);
  return std::sqrt(dx * dx + dy * dy);
}

bool is_on_field(const Field& field, const Vec2& point_m) {
  return std::abs(point_m.x()) <= field.half_length_m() &&
         std::abs(point_m.y()) <= field.half_width_m();
}

Vec2 inside_walls(const Field& field, const Vec2& point_m) {
  const double x_m = field.wall_x_m() - kRobotRadius_m;
  const double y_m = field.wall_y_m() - kRobotRadius_m;
  return {std::clamp(point_m.x(), -x_m, x_m), std::clamp(point_m.y(), -y_m, y_m)};
}

}  // namespace autoref
