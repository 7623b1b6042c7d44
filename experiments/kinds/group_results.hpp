// The results of kinds whose games are grouped by values or by matchup.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/results.hpp"

namespace autoref::experiments {

// A table of groups while the experiment runs. On a narrow screen it first drops the goals, since
// their difference is shown, and the void games, since the progress bar counts them.
io::ProgressTable groups_progress_table(std::vector<io::Cells> rows, std::vector<io::Align> columns,
                                        std::string noun);

// The same for matchups, which can also do without the number of games: it is the sum of the wins,
// draws and losses on the right.
io::ProgressTable matchups_progress_table(const std::vector<Group>& matchups);

// The results of a tournament, to which a kind may add files and blocks of its table: the report
// shows them, too. `noun` is who stands in the standings, in the singular: "team" or
// "challenger".
ExperimentResults tournament_results(std::vector<Group> matchups, std::vector<Standing> standings,
                                     const std::string& noun);

}  // namespace autoref::experiments
