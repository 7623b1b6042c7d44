// The scheduled games for which a folder already has rows.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "experiments/results/shard.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

struct CompletedGames {
  RowsById done;                            // rows of scheduled games
  std::map<std::string, int> other_builds;  // number of rows by build
  int other_games = 0;                      // number of this build's rows of unscheduled games
};

// Whether the game in this row is void because its worker was killed from outside. The next run
// replays it.
bool is_killed(const GameRow& row);

// Separates the rows that count from the others. Throws InputError if there are rows of other
// builds and builds must not be mixed, or if a scheduled game was played with another
// configuration. Throws std::logic_error if two rows of a game differ in a reproducible column,
// unless one of the rows belongs to a killed game. `folder` and `changes` (the differences between
// the folder's scenario and this one) are for messages.
CompletedGames sort_rows(RowsInFiles rows, const std::vector<ScheduledGame>& games,
                         const RowFormat& format, const std::string& build, bool allow_mixed_build,
                         const std::filesystem::path& folder, const std::string& changes);

struct RowInventory {
  Schedule schedule;
  CompletedGames completed_games;  // including games that are not needed
};

// Sorts the rows for a scenario's schedule, which may depend on the rows. Throws like sort_rows().
RowInventory take_row_inventory(const Scenario& scenario, RowsInFiles rows, const RowFormat& format,
                                const std::string& build, bool allow_mixed_build,
                                const std::filesystem::path& folder, const std::string& changes);

}  // namespace autoref::experiments
