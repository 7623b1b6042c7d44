// From settings to the game that is played.
#pragma once

#include <string>

#include "runner/game/configuration.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// Sets what belongs to the rule book of that name: rules, field, robots and length of a half.
// Throws std::invalid_argument for an unknown name.
void choose_rules(const std::string& book, GameSettings& game);

// The game that the settings describe: the rule book with its rules switched on and off, and each
// robot with the changes of its type, its team and its number. Names are looked up, but values are
// not checked; check_game() (fields.hpp) does that. Throws std::invalid_argument for an unknown
// rule book, and SettingError for an unknown robot type and for a player whose number the team does
// not have.
GameConfiguration resolved(const GameSettings& settings);

}  // namespace autoref::runner
