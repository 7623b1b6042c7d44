// All teams by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "strategies/strategy.hpp"

namespace autoref::strategies {

struct Entry {
  std::string_view name;   // as in a scenario's `strategy:`
  std::string_view about;  // description in one sentence
  std::unique_ptr<Strategy> (*make)(const TeamContext& context);
  std::vector<Tunable> params;  // parameters allowed in `params:`
};

// All teams, ordered by name.
const std::vector<Entry>& all_strategies();

// The names of the teams that are not variants of another one, the strongest first: their ranks in
// results/reference/roundrobin/standings.csv.
const std::vector<std::string_view>& teams_by_strength();

// The team with that name; nullptr if there is none.
const Entry* find_strategy(std::string_view name);

}  // namespace autoref::strategies
