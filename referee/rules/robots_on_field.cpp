#include "referee/rules/robots_on_field.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

// Whether any part of the circle around the robot is within the lines.
bool reaches_field(const Field& field, const Vec2& position_m) {
  return std::abs(position_m.x()) < field.half_length_m() + kRobotRadius_m &&
         std::abs(position_m.y()) < field.half_width_m() + kRobotRadius_m;
}

}  // namespace

int robots_on_field(const RefereeInput& input, Side side) {
  const SeenRobots& robots = input.frame.robots[side];
  return static_cast<int>(
      std::count_if(robots.begin(), robots.end(), [&](const RobotObservation& robot) {
        return reaches_field(input.configuration.field, robot.position_m);
      }));
}

}  // namespace autoref::referee
