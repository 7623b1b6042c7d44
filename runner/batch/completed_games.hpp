// Which games of a plan are done, by the rows that a folder holds.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runner/batch/experiment_kinds.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/results/shard.hpp"

namespace autoref::runner {

struct CompletedGames {
  RowsById done;                            // the games of the plan
  std::map<std::string, int> other_builds;  // how many rows of which
  int other_games = 0;                      // rows of this build whose games are not in the plan
};

// Whether the game is void because its worker was killed from outside: the next run plays it again.
bool is_killed(const Cells& row, const RowFormat& format);

// Sorts rows into a stock. Throws InputError for rows of other builds unless those are allowed,
// and for a game of the plan that was played with another configuration; std::logic_error
// where two rows of a game differ in what must be reproducible, but for rows of killed games.
// `folder` and `changes` (what differs between the folder's scenario and this one) are for
// messages.
CompletedGames sort_rows(const std::vector<StoredRow>& rows,
                         const std::vector<ScheduledGame>& games, const RowFormat& format,
                         const std::string& build, bool allow_mixed_build,
                         const std::filesystem::path& folder, const std::string& changes);

struct RowInventory {
  Schedule schedule;
  CompletedGames completed_games;  // of all its games, also those that are not needed
};

// A stock of the games that the scenario takes, which may follow from the rows. Throws likewise.
RowInventory take_row_inventory(const Scenario& scenario, const std::vector<StoredRow>& rows,
                                const RowFormat& format, const std::string& build,
                                bool allow_mixed_build, const std::filesystem::path& folder,
                                const std::string& changes);

}  // namespace autoref::runner
