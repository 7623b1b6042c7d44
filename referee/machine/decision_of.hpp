// Turns a step of the machine into a row of the event log.
#pragma once

#include "referee/decision.hpp"
#include "referee/machine/machine.hpp"

namespace autoref::referee {

// The decision that `finding` led to in the state `before`, including the state of the game and the
// card shown.
Decision decision_of(const RefereeState& before, const RefereeInput& input, const Finding& finding,
                     const Step& taken);

}  // namespace autoref::referee
