// Games between a program and another team, for `team check` and `team play`.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "game/settings/game_settings.hpp"

namespace autoref::app {

// Adds the program and its arguments as one argument.
void add_program_argument(CLI::App& verb, std::string& command);

// A game by the rules of 2026 with the program as team a and the given "key=value" settings. Throws
// InputError.
game::GameSettings team_game(const std::string& command, const std::string& opponent, double half_s,
                             const std::vector<std::string>& sets);

}  // namespace autoref::app
