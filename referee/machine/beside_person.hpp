// AutoRef beside a person: the person (or the game controller) commands the game, AutoRef follows
// and calls what it sees.
//
// "AutoRef ... stops play at once" on its own call and then waits for the person's signal (paper,
// sections 4.1 and 5): it sends STOP, and goes on observing. If no command follows and play visibly
// goes on, or after 15 s, the call was overruled. Scores, cards and stages are the person's.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// Whether `given` contains another command than the person's last signal.
bool is_new_command(const RefereeState& state, const RefereeSignal& given);

// Takes score, cards, stage, placement and next command from the person's signal.
void take_values(RefereeState& state, const RefereeInput& input);

// The finding that the person has given the command in `state.person.given`. Its evidence says
// whether the command contradicts AutoRef's call.
Finding finding_of_command(const RefereeState& state);

// In CALLED: kOverruled once play visibly goes on, or 15 s after the call. Play visibly goes on if
// the ball has been on the field for a second and a robot of each team has been faster than a stop
// allows within that second; robots have 2 s to slow down. It also goes on if the ball leaves the
// field: without a signal, this is an event of its own.
std::optional<Finding> find_overruled(RefereeState& state, const RefereeInput& input);

// Whether the finding is an event that has been called in this play already: the same event by the
// same side, until it has not been found for a second; or any event while the ball stays outside
// the field. Notes that it was found again.
bool is_called_already(RefereeState& state, const RefereeInput& input, const Finding& finding);

}  // namespace autoref::referee
