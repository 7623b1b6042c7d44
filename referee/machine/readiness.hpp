// Whether play can start or go on: the looks at the robots of the paper's section 4.4, "Robot
// Positions", the ball at its place, and the timeouts.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

SavedPositions positions_in(const Frame& frame);

// How far the robots of each side that moved most have moved since the positions were saved: 0
// for a side none of whose robots is seen both then and now.
struct LargestMoves {
  PerSide<double> move_m;
  PerSide<std::optional<RobotId>> robot;
};
LargestMoves largest_moves(const SavedPositions& saved, const Frame& frame);

// In WAIT_START: kRobotsMoved at a periodic look in which at least one robot of each team is more
// than epsilon from where it was saved, kStartTimeout when the wait is over.
std::optional<Finding> find_start(RefereeState& state, const RefereeInput& input);

// In WAIT_STOP: kReady at a periodic look in which every robot is within epsilon of where it was
// at the look before and the ball rests at its position; kReadyTimeout when the wait is over. Saves
// the positions at each look that finds somebody moving, and has the ball set to its place at once
// shortly before the wait is over.
std::optional<Finding> find_ready(RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
