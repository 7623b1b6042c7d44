// Robots that differ from the game's: combines types and overrides into the robots of a team.
#pragma once

#include <string>

#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::game {

// The overrides of the named type, themselves overridden by `changes`. Throws SettingError for the
// path `type` if there is no such type.
RobotChanges merged(const RobotTypes& types, const std::string& type, const RobotChanges& changes);

// Applies the changes to a robot.
void apply_changes(const RobotChanges& changes, sim::RobotSpec& robot);

// Sets one change, or all changes that an alias such as a preset stands for.
void set_change(const Change& change, const SettingValue& value);

// The value after the changes, or a robot's default if it is not changed.
SettingValue changed_value(const Change& change);

// The robots of a team of `game`. Their values come from, in increasing priority, the game's robot,
// the team's type, the team's changes, the player's type and the player's changes; a player's
// factors are multiplied by the team's. Throws SettingError for an unknown type, and for a player
// whose number the team does not have; `path` is that of the team's settings, such as "teams.a".
sim::TeamSpec spec_of(const GameSettings& game, const TeamSettings& team, std::string_view path);

}  // namespace autoref::game
