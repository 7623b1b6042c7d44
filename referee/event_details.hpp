// What a finding's league event needs beyond the finding itself.
#pragma once

#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Only what is known is set. Positions are in the referee's coordinates.
struct EventDetails {
  std::optional<RobotId> robot;  // the robot at fault, if it is not the finding's first one
  std::optional<Vec2> robot_m;   // its position
  std::optional<Vec2> ball_m;
  std::optional<Vec2> kick_m;               // of a goal: where the ball was kicked
  std::optional<Vec2> dribble_from_m;       // where the ball was when the robot gained it
  std::optional<double> ball_top_m;         // greatest height of its top since the scorers' touch
  std::optional<double> scorers_touched_s;  // time of that touch
  std::optional<bool> is_chipped;           // of a kick
  std::optional<int> robots;                // of the side concerned, on the field
  std::optional<int> robots_allowed;        // of the same side
  std::optional<double> speed_difference_mps;  // of colliding robots
  std::optional<double> crash_angle_rad;       // between their velocities, at most pi
  std::optional<double> waited_s;              // without progress
  std::optional<double> to_target_m;           // from the ball to its designated position
  std::optional<double> from_target_m;         // the same when the placement began
  std::optional<double> own_robot_to_ball_m;   // of the placing team's nearest robot, between hulls
};

}  // namespace autoref::referee
