#include "soccer/robot_shape.hpp"

#include <algorithm>
#include <cmath>

namespace autoref {

double distance_to_hull(const Vec2& point_m, const Vec2& centre_m, const Vec2& heading) {
  const Vec2 p = to_local(point_m - centre_m, heading);
  const double to_disc = p.norm() - kRobotRadius_m;
  const double to_plate = p.x() - kFrontDistance_m;
  if (to_plate <= 0.0) return std::max(to_disc, to_plate);
  const double y = std::abs(p.y());
  if (y <= kHalfPlate_m) return to_plate;
  // Beside the plate's corner the round hull is nearest, in front of it the corner itself.
  if (y * kFrontDistance_m > p.x() * kHalfPlate_m) return to_disc;
  return std::sqrt(to_plate * to_plate + (y - kHalfPlate_m) * (y - kHalfPlate_m));
}

}  // namespace autoref
