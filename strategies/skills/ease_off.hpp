// Avoiding contact with opponents.
#pragma once

#include "soccer/robot_command.hpp"
#include "soccer/tracks.hpp"

namespace autoref::strategies {

// How gently a robot approaches opponents. The defaults nearly rule out crashes.
struct Easing {
  double from_m = 1.2;         // gap between hulls below which the closing speed is limited
  double gentle_mps = 0.2;     // closing speed allowed at contact
  double braking_mps2 = 1.2;   // from which the speed allowed at a distance follows
  double contact_mps = 100.0;  // largest speed towards an opponent in contact; no robot is as fast
};

// Limits the closing speed of `robot` towards each nearby opponent to a braking curve over the gap.
// Only the component towards the opponent is reduced, so the robot can still slide past it.
void ease_off(const TrackedRobot& robot, const TrackedRobots& opponents, const Easing& easing,
              RobotCommand& command);

}  // namespace autoref::strategies
