// The results of experiments that rate the versions of a team over time.
#pragma once

#include "experiments/kinds/results.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/schedule/team_versions.hpp"

namespace autoref::experiments {

// Adds the ratings of all teams in the standings, and of the teams that are taken over, to the
// results of a tournament: versions.csv, version_pairs.csv, a table and JSON. Adds nothing if the
// experiment follows no ratings.
void add_version_ratings(ExperimentResults& results, const TeamVersions& versions,
                         const RowsById& rows, RatedAgainst against);

}  // namespace autoref::experiments
