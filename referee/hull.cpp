#include "referee/hull.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

constexpr double kDeviations = 3;  // of noise: one picture in several hundred is farther off

// The unit vector from `point_m` to the nearest point of the defence area of `side`.
Vec2 direction_to_area(const Field& field, Side side, const Vec2& point_m) {
  const DefenceArea& area = field.defence_area;
  const double half_m = area.straight_m / 2;
  const bool round = area.shape == DefenceArea::Shape::kQuarterCircles;
  // Quarter circles are as far away as their centres on the goal line, but for their radius.
  const double depth_m = round ? 0.0 : area.depth_m;
  const double inwards = -goal_sign(side);
  const double from_line_m = (point_m.x() - field.goal_centre_m(side).x()) * inwards;
  const Vec2 nearest_m(
      field.goal_centre_m(side).x() + inwards * std::clamp(from_line_m, 0.0, depth_m),
      std::clamp(point_m.y(), -half_m, half_m));
  return direction_of(nearest_m - point_m, Vec2(-inwards, 0));
}

}  // namespace

double reach_of_hull_m(const Vec2& heading, const Vec2& way) {
  const Vec2 local = to_local(way, heading);
  if (local.x() * kRobotRadius_m < kFrontDistance_m) return kRobotRadius_m;
  return local.x() * kFrontDistance_m + std::abs(local.y()) * kHalfPlate_m;
}

double hull_to_area_m(const Field& field, Side side, const RobotObservation& robot) {
  return distance_to_defence_area(field, side, robot.position_m) -
         reach_of_hull_m(robot.heading, direction_to_area(field, side, robot.position_m));
}

double robot_doubt_m(const VisionNoise& noise) { return kDeviations * noise.robot_m; }

double robot_to_ball_doubt_m(const VisionNoise& noise) {
  return kDeviations * std::hypot(noise.robot_m, noise.ball_m);
}

}  // namespace autoref::referee
