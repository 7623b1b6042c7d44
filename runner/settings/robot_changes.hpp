// Robots that differ from the game's: from types and single changes to the robots of a team.
#pragma once

#include <string>

#include "runner/settings/configuration.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {

// What the type of that name changes and, over it, `changes`. Throws std::invalid_argument where
// there is no such type.
RobotChanges merged(const RobotTypes& types, const std::string& type, const RobotChanges& changes);

// Makes the changes to a robot.
void apply_changes(const RobotChanges& changes, sim::RobotSpec& robot);

// Reads `text` into one change, or into all that an alias such as a preset sets. Throws
// std::invalid_argument that says what was expected.
void assign_change(const Change& change, std::string_view text);

// The value after the changes; where it is not changed, a robot's default.
std::string changed_value(const Change& change);

// The robots of a team of `game`. What they have comes from the game's robot, the team's type, the
// team's changes, the player's type, the player's changes, the later over the former; a player's
// factors are multiplied with the team's. Throws std::invalid_argument for a player with a number
// that the team does not have, and for an unknown type.
sim::TeamSpec spec_of(const GameConfiguration& game, const TeamConfiguration& team);

}  // namespace autoref::runner
