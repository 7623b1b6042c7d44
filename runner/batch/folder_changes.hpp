// What an experiment changes of the folder that it is to go on in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// The scenario that a folder was filled with last; none where that is not known.
std::optional<Scenario> scenario_of_folder(const std::filesystem::path& folder);

// Throws InputError that says how to go on where the folder's games have another seed.
void refuse_other_seed(const Scenario& here, const Scenario& there,
                       const std::filesystem::path& folder);

// "6 pairs so far, 12 now: only the games that are new are played"; empty where there are as many
// as before. `beyond` counts rows of games that the scenario does not have.
std::string note_on_pairs(const Scenario& here, const Scenario& there, int beyond);

}  // namespace autoref::runner
