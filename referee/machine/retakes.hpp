// Restarts that are retaken because their own rules were broken: opponents too near, robots in the
// wrong half, robots out of position at a penalty kick (Laws 8, 13 and 14).
#pragma once

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"

namespace autoref::referee {

// Whether the current restart may be retaken. AutoRef's own limit is three retakes, so that a team
// that always breaks the rules cannot hang a game. After that, play continues.
bool may_be_taken_again(const RefereeState& state);

// Sets the finding's restart to the current one, from the same position.
void take_again(Finding& finding, const PlayState& play);

// The retakes to record after the finding has stopped play; empty if a different restart follows.
Retakes retakes_after(const Retakes& before, const Finding& finding);

}  // namespace autoref::referee
