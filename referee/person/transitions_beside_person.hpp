// The machine's transitions while a person or nobody commands the game.
#pragma once

#include <span>

#include "referee/machine/machine.hpp"

namespace autoref::referee {

std::span<const Transition> transitions_beside_person();

// Whether play can begin after this command.
bool starts_play(CommandKind kind);

// Takes the score, cards, stage, placement and next command from the person's signal.
void take_values(RefereeState& state, const RefereeInput& input);

}  // namespace autoref::referee
