// Compares an experiment with the folder it continues in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "experiments/kinds/scenario.hpp"

namespace autoref::experiments {

// The scenario of the last run in a folder; nullopt if unknown.
std::optional<Scenario> scenario_of_folder(const std::filesystem::path& folder);

// Throws InputError, with advice on how to continue, if the folder's games have a different seed.
void refuse_other_seed(const Scenario& here, const Scenario& there,
                       const std::filesystem::path& folder);

// "the folder had 6 pairs, now 12; its games count, and only the new ones are played"; empty if the
// number has not changed. `beyond` is the number of rows whose games are not in the scenario, or
// not known to be yet.
std::string note_on_pairs(const Scenario& here, const Scenario& there, int beyond);

}  // namespace autoref::experiments
