// Command-line overrides of an experiment's number of pairs and seed.
#pragma once

#include <cstdint>
#include <optional>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

inline constexpr int kMostPairs = 9999;  // pairs of legs

// The number of pairs of legs per combination or matchup, or the max_pairs of an SPRT match.
// Nullopt for a knockout and for kind judge.
std::optional<int> pairs_of(const Scenario& experiment);

// The experiment's master seed; nullopt for kind judge with named seeds.
std::optional<std::uint64_t> master_seed_of(const Scenario& experiment);

// Throws std::invalid_argument if the experiment cannot have this many pairs.
void set_pairs(Scenario& experiment, int pairs);

// Replaces all named seeds, too.
void set_master_seed(Scenario& experiment, std::uint64_t seed);

}  // namespace autoref::runner
