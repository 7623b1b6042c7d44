// The goal that is awarded for a foul by the defenders at a penalty kick (2026, Penalty Kick).
#pragma once

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// kGoal for the kicker's side, wherever the ball is. Play must be a penalty kick.
Finding awarded_goal(const RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
