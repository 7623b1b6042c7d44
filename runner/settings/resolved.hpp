// From settings to the game that is played.
#pragma once

#include <string>

#include "runner/game/configuration.hpp"
#include "runner/settings/game_settings.hpp"

namespace autoref::runner {

// Takes what belongs to the rule book of that name: its rules, field, robots and length of a half.
// Throws std::invalid_argument where there is none.
void choose_rules(const std::string& book, GameSettings& game);

// The game that the settings describe: the rule book with its rules as they are switched, and each
// robot with all that its team, its type and its number change. Only names and numbers are looked
// up here; check_game() (fields.hpp) says whether the values go together. Throws
// std::invalid_argument for an unknown rule book, and SettingError for an unknown type of robots
// and for a player with a number that its team does not have.
GameConfiguration resolved(const GameSettings& settings);

}  // namespace autoref::runner
