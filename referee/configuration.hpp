// The referee's configuration.
#pragma once

#include "referee/match.hpp"
#include "referee/touch_parameters.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"
#include "tracking/tracker.hpp"

namespace autoref::referee {

// The match, and where and by whom it is played. `on_team_fault` and `a_plays` are not the
// referee's.
struct Configuration : Match {
  Field field;
  PerSide<int> robots{{kMaxRobots, kMaxRobots}};  // per team, at the start
  tracking::VisionNoise noise;                    // noise in the vision frames
  double camera_error_m = 0;  // lasting error of a camera's positions, root mean square
  TouchParameters touch;      // thresholds of the touch detector
};

}  // namespace autoref::referee
