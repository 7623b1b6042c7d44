// The game of a scenario that the user names.
#pragma once

#include <string>
#include <vector>

#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref::app {

// The game of a scenario with the assignments applied. An empty seed keeps the scenario's seed.
// Throws InputError for a scenario of another kind, naming the verb that plays it.
game::GameSettings game_in(const std::string& file, const std::string& seed,
                           const game::Assignments& assignments);

// The files from which a game is read: the scenario file, the recorded commands (unless empty) and
// the robot type files named by the scenario or by --set.
std::vector<std::string> inputs_of(const std::string& file, const std::string& commands,
                                   const game::Assignments& assignments);

}  // namespace autoref::app
