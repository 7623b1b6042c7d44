// Restarts that are taken again because somebody broke their own rules: opponents too near, robots
// in the wrong half, a penalty kick with robots out of place (Laws 8, 13 and 14).
#pragma once

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"

namespace autoref::referee {

// Whether the restart that is on may be taken once more. Ours: at most three times, so that a team
// that never learns cannot hang a game; then play goes on.
bool may_be_taken_again(const RefereeState& state);

// Makes the restart that is on what the finding leads to, from its own place.
void take_again(Finding& finding, const PlayState& play);

// What to remember of the next restart once the finding has stopped play: nothing where it is
// another one.
Retakes retakes_after(const Retakes& before, const Finding& finding);

}  // namespace autoref::referee
