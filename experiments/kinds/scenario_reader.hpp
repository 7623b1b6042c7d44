// Reads scenario files and writes the effective scenario of a results folder.
#pragma once

#include <filesystem>
#include <string>

#include "experiments/kinds/scenario.hpp"
#include "game/settings/assignments.hpp"

namespace autoref::experiments {

// Reads a scenario strictly: every key must be known and given only once, and every value must be
// in range. Missing keys keep their defaults. Assignments change settings of a game, of the base
// shared by all games, or of a named team (teams.NAME.robots). Throws InputError with file, line
// and key, or with the command-line flag.
Scenario read_scenario(const std::filesystem::path& file,
                       const game::Assignments& assignments = {});
Scenario read_scenario_text(const std::string& text, const std::string& file_name,
                            const game::Assignments& assignments = {});

// The scenario with every setting written out and explained in a comment. Reading it back yields
// the same scenario. Throws InputError if the text would be too long to read back.
std::string effective_text(const Scenario& scenario);

}  // namespace autoref::experiments
