// Decides when play can start or continue. Contains the periodic checks of the robots in the
// paper's section 4.4, "Robot Positions", the check that the ball is at its position, and the
// timeouts.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

SavedPositions positions_in(const Frame& frame);

// For each side, the largest move of any of its robots since the positions were saved; 0 if no
// robot of the side was seen both then and now.
struct LargestMoves {
  PerSide<double> move_m;
  PerSide<std::optional<RobotId>> robot;
};
LargestMoves largest_moves(const SavedPositions& saved, const Frame& frame);

// The largest distance in metres between the ball as vision sees it and its designated position at
// which the ball counts as being there. This is the rule book's tolerance plus twice the cameras'
// systematic error.
double ball_tolerance_m(const Configuration& configuration);

// Records how long the ball has been at its designated position.
void watch_ball(RefereeState& state, const RefereeInput& input);

// In WAIT_START, returns kRobotsMoved if a periodic check finds at least one robot of each team
// more than epsilon from its saved position, or kStartTimeout after the timeout.
std::optional<Finding> find_start(RefereeState& state, const RefereeInput& input);

// In WAIT_STOP, returns kReady or, after the timeout, kReadyTimeout. The game is ready if a
// periodic check finds every robot within epsilon of its position at the previous check, and the
// ball at rest at its designated position. Saves the positions at each check that finds a robot
// moving, and, shortly before the timeout, requests that the ball be set to its position.
std::optional<Finding> find_ready(RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
