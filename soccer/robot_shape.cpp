#include "soccer/robot_shape.hpp"

#include <algorithm>
#include <cmath>

namespace autoref {

double distance_to_hull(const Vec2& point_m, const Vec2& centre_m, const Vec2& heading) {
  const Vec2 p = to_local(point_m - centre_m, heading);
  const double to_disc = p.norm() - kRobotRadius_m;
  const double to_plate = p.x() - kFrontDistance_m;
  // The hull is a disc cut by a half-plane: behind the cut, the signed distance to the intersection
  // is the larger of the two.
  if (to_plate <= 0.0) return std::max(to_disc, to_plate);
  const double y = std::abs(p.y());
  if (y <= kHalfPlate_m) return to_plate;
  // Beyond the plate's corner the nearest point is on the arc, or is the corner itself.
  if (y * kFrontDistance_m > p.x() * kHalfPlate_m) return to_disc;
  return std::sqrt(to_plate * to_plate + (y - kHalfPlate_m) * (y - kHalfPlate_m));
}

bool meets_hull(const Vec2& a_m, const Vec2& b_m, const Vec2& centre_m, const Vec2& heading) {
  Vec2 near_m = to_local(a_m - centre_m, heading);
  Vec2 far_m = to_local(b_m - centre_m, heading);
  if (near_m.x() > far_m.x()) std::swap(near_m, far_m);
  if (near_m.x() > kFrontDistance_m) return false;
  // Clips the segment at the plane of the plate.
  if (far_m.x() > kFrontDistance_m) {
    const double kept = (kFrontDistance_m - near_m.x()) / (far_m.x() - near_m.x());
    far_m = near_m + (far_m - near_m) * kept;
  }
  return distance_to_segment({0.0, 0.0}, near_m, far_m) <= kRobotRadius_m;
}

}  // namespace autoref
