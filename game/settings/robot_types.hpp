// Robot types, and the robots of a team, which combine types and overrides. A robot type is a file
// that overrides some of the game's robot settings:
//
//   schema: 1
//   kind: robot
//   about: One sentence.
//   robot: { speed_mps: 2.2 }       # keys as below `sim.`; anything not given is unchanged
//   kicker: { ... }
//   dribbler: { ... }
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::game {

// Reads a type as strictly as a scenario. Throws InputError with file, line and key.
RobotChanges read_robot_type_text(const std::string& text, const std::string& file_name);

// Resolves a type that a user gave as `text` and returns its name in `types`. `text` is a name in
// `types` or the path of a file relative to `folder`, which is then read into `types`;
// "robots/slow.yaml" becomes "slow". Throws std::invalid_argument if the file cannot be read or if
// another type already has that name, and InputError for errors inside the file.
std::string take_type(const std::string& text, const std::filesystem::path& folder,
                      RobotTypes& types);

// The overrides of the named type, with `changes` taking precedence. Throws SettingError for the
// path `type` if there is no such type.
RobotChanges merged(const RobotTypes& types, const std::string& type, const RobotChanges& changes);

// Applies the changes to a robot.
void apply_changes(const RobotChanges& changes, sim::RobotSpec& robot);

// Sets one change, or all changes that an alias such as a preset stands for.
void set_change(const Change& change, const SettingValue& value);

// The value after the changes; if it is not changed, the default of a robot.
SettingValue changed_value(const Change& change);

// The robots of a team of `game`. Their values come from, in increasing priority, the game's robot,
// the team's type, the team's changes, the player's type and the player's changes; a player's
// factors are multiplied by the team's. Throws SettingError for an unknown type, and for a player
// number that the team does not have; `path` is that of the team's settings, such as "teams.a".
sim::TeamSpec spec_of(const GameSettings& game, const TeamSettings& team, std::string_view path);

}  // namespace autoref::game
