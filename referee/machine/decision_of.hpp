// A step of the machine as a row of the event log.
#pragma once

#include "referee/decision.hpp"
#include "referee/machine/machine.hpp"

namespace autoref::referee {

// What was decided on `finding` in the state `before`, with the game's standing and the card that
// it led to.
Decision decision_of(const RefereeState& before, const RefereeInput& input, const Finding& finding,
                     const Step& taken);

}  // namespace autoref::referee
