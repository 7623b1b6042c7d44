// Turns settings into the configuration that is played.
#pragma once

#include <string>

#include "game/loop/configuration.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::game {

// Applies the rule book of that name: rules, field, number of robots and length of a half. Throws
// std::invalid_argument for an unknown name.
void choose_rules(const std::string& book, GameSettings& game);

// The game that the settings describe: the rule book with its switched rules, and each robot with
// the overrides of its type, its team and its number. Looks up names but does not check values;
// check_game() (fields.hpp) does. Throws std::invalid_argument for unknown laws of a team, and
// SettingError for an unknown robot type or for a player number that the team does not have.
GameConfiguration resolved(const GameSettings& settings);

}  // namespace autoref::game
