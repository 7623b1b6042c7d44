#include "referee/geometry/area.hpp"

#include <algorithm>
#include <cmath>

#include "referee/geometry/hull.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// The unit vector from `point_m` to the nearest point of the defence area of `side`.
Vec2 direction_to_area(const Field& field, Side side, const Vec2& point_m) {
  const DefenceArea& area = field.defence_area;
  const double half_m = area.straight_m / 2;
  const bool round = area.shape == DefenceArea::Shape::kQuarterCircles;
  // A quarter circle contains all points within its radius of one point on the goal line.
  const double depth_m = round ? 0.0 : area.depth_m;
  const double inwards = -goal_sign(side);
  const double from_line_m = (point_m.x() - field.goal_centre_m(side).x()) * inwards;
  const Vec2 nearest_m(
      field.goal_centre_m(side).x() + inwards * std::clamp(from_line_m, 0.0, depth_m),
      std::clamp(point_m.y(), -half_m, half_m));
  return direction_of(nearest_m - point_m, Vec2(-inwards, 0));
}

Vec2 plate_corner_m(const RobotObservation& robot, double end) {
  return robot.position_m + to_world(Vec2(kFrontDistance_m, end * kHalfPlate_m), robot.heading);
}

double out_of_round_area_m(const Field& field, Side side, const RobotObservation& robot) {
  const double centre_m = distance_to_defence_area(field, side, robot.position_m);
  const Vec2 outwards = -direction_to_area(field, side, robot.position_m);
  if (outwards.dot(robot.heading) * kRobotRadius_m < kFrontDistance_m) {
    return centre_m + kRobotRadius_m;
  }
  // The flat front cuts off the farthest point of the circle, so a corner of the front is farthest.
  return std::max(distance_to_defence_area(field, side, plate_corner_m(robot, 1)),
                  distance_to_defence_area(field, side, plate_corner_m(robot, -1)));
}

double out_of_box_m(const Field& field, Side side, const RobotObservation& robot) {
  const DefenceArea& area = field.defence_area;
  const double inwards = -goal_sign(side);
  const double aside = std::copysign(1.0, robot.position_m.y());
  const double depth_m = (robot.position_m.x() - field.goal_centre_m(side).x()) * inwards;
  // The hull is inside the box if its extreme points in both outward directions are. The support
  // function gives them without computing the outline.
  const double over_front_m =
      depth_m + reach_of_hull_m(robot.heading, Vec2(inwards, 0)) - area.depth_m;
  const double over_side_m = std::abs(robot.position_m.y()) +
                             reach_of_hull_m(robot.heading, Vec2(0, aside)) - area.straight_m / 2;
  return std::max(over_front_m, over_side_m);
}

}  // namespace

double hull_to_area_m(const Field& field, Side side, const RobotObservation& robot) {
  // The supporting line at the area's nearest point separates hull and area, so the gap is the
  // centre's distance minus the hull's reach towards that point.
  return distance_to_defence_area(field, side, robot.position_m) -
         reach_of_hull_m(robot.heading, direction_to_area(field, side, robot.position_m));
}

double hull_out_of_area_m(const Field& field, Side side, const RobotObservation& robot) {
  const bool round = field.defence_area.shape == DefenceArea::Shape::kQuarterCircles;
  return round ? out_of_round_area_m(field, side, robot) : out_of_box_m(field, side, robot);
}

}  // namespace autoref::referee
