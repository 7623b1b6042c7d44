// What a command line may change of an experiment's file: how many pairs, and the seed.
#pragma once

#include <cstdint>
#include <optional>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

inline constexpr int kMostPairs = 9999;  // of legs

// The pairs of legs of each combination or matchup; an SPRT match's max_pairs. None of a knockout,
// which has none.
std::optional<int> pairs_of(const Scenario& experiment);

// The seed of the whole experiment.
std::uint64_t master_seed_of(const Scenario& experiment);

// Throws std::invalid_argument that says why the experiment cannot have so many.
void set_pairs(Scenario& experiment, int pairs);

void set_master_seed(Scenario& experiment, std::uint64_t seed);

}  // namespace autoref::runner
