// Where kicker and dribbler act: in front of the front plate.
#pragma once

#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::sim {

// Whether a ball at `ball_m`, with its lowest point at `height_m`, is in the robot's dribbler zone:
// its surface within `reach_m` of the plate, its centre within the zone's width, and low enough for
// a roller at the height of the centre of a ball on the carpet.
template <typename Robot>  // BodyState or RobotState
bool is_in_dribbler_zone(const Robot& robot, const Vec2& ball_m, double height_m, double reach_m) {
  if (height_m > kBallRadius_m) return false;
  const Vec2 local_m = to_local(ball_m - robot.position_m, robot.heading);
  return local_m.x() > kFrontDistance_m &&
         local_m.x() <= kFrontDistance_m + kBallRadius_m + reach_m &&
         std::abs(local_m.y()) <= kDribblerZoneWidth_m / 2.0;
}

}  // namespace autoref::sim
