// Decides when play can start or continue: the periodic checks of the robots in the paper's section
// 4.4, "Robot Positions", the ball at its position, and the timeouts.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

SavedPositions positions_in(const Frame& frame);

// The largest move of any robot of each side since the positions were saved: 0 if no robot of the
// side was seen both then and now.
struct LargestMoves {
  PerSide<double> move_m;
  PerSide<std::optional<RobotId>> robot;
};
LargestMoves largest_moves(const SavedPositions& saved, const Frame& frame);

// How far from its position, in metres, a ball at its position may be seen: the rule book's
// tolerance and twice the cameras' lasting error.
double ball_tolerance_m(const Configuration& configuration);

// Records since when the ball has been at its position.
void watch_ball(RefereeState& state, const RefereeInput& input);

// In WAIT_START: kRobotsMoved if a periodic check finds at least one robot of each team more than
// epsilon from its saved position, or kStartTimeout after the timeout.
std::optional<Finding> find_start(RefereeState& state, const RefereeInput& input);

// In WAIT_STOP: kReady if a periodic check finds every robot within epsilon of its position at the
// previous check and the ball at rest at its position, or kReadyTimeout after the timeout. Saves
// the positions at each check that finds a robot moving, and requests the ball to be set to its
// position shortly before the timeout.
std::optional<Finding> find_ready(RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
