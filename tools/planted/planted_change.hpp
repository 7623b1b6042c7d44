// Comparisons of a team with a copy of it that has a planted change.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/results/game_row.hpp"
#include "strategies/strategy.hpp"

namespace autoref::tools {

// Changes a team's commands.
using CommandChange = std::function<void(const strategies::Strategy& team, const TeamView& view,
                                         const Field& field, TeamCommands& commands)>;

struct TeamSettingChange {
  std::string path;  // below the team's settings, such as "params.receivers"
  std::string value;
};

struct PlantedChange {
  std::string name;
  CommandChange change;                     // of the new team's commands; empty: none
  std::vector<TeamSettingChange> settings;  // of the new team
};

// The keeper moves at 30 % of its speed.
PlantedChange slow_keeper();

PlantedChange never_passes();

// Cobalt with the settings of the change (new) against cobalt without them (old), under the rules
// of 2026-b. Throws std::invalid_argument if a setting is invalid.
experiments::Comparison comparison_of(const PlantedChange& change, int pairs);

// The comparison's only matchup, in which the new team is team a.
std::string matchup_of(const experiments::Comparison& comparison);

// Plays all games of the comparison in one process per processor. Throws std::runtime_error if a
// game is void or given up, and io::Interrupted after a signal.
experiments::RowsById play_all(const experiments::Comparison& comparison,
                               const CommandChange& change);

}  // namespace autoref::tools
