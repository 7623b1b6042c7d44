// A results folder, as filled by `autoref run` and `autoref judge`: the scheduled games and the
// rows of the games played so far.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "experiments/results/row_format.hpp"
#include "experiments/run/completed_games.hpp"
#include "experiments/schedule/schedule.hpp"

namespace autoref::experiments {

struct ResultFolder {
  std::filesystem::path path;
  Scenario scenario;  // the scenario in effective.yaml
  RowFormat format;
  std::vector<ScheduledGame> games;  // as in Schedule
  std::size_t needed = 0;            // as in Schedule
  std::string build;                 // only the rows of this build count
  CompletedGames completed_games;    // `done` contains only rows that count
  int beyond = 0;                    // number of rows of games that turned out not to be needed
  // Damaged rows, which do not count; empty if every game has a row.
  std::vector<DamagedRow> damaged;
  // Ids of the games that are in results.csv but have no row; empty if there are several builds.
  std::vector<std::string> lost;
  std::map<std::string, int> by_shard;  // number of games played by each shard, such as "0/1"

  // Positions in `games` of those with rows that are neither void nor forfeited.
  std::vector<std::size_t> good_games() const;
  int void_games() const;
  int killed_games() const;  // number of void games that the next run replays
  // The faults of the stored rows, one line for each; empty if there are none.
  std::set<std::string> faults() const;
  bool is_complete() const { return completed_games.done.size() == needed; }
};

// The scenario that the folder's rows belong to. Throws InputError if the folder is not a results
// folder.
Scenario scenario_in(const std::filesystem::path& folder);

// The builds that have rows in a results folder. Throws InputError if the folder is not a results
// folder.
std::set<std::string> builds_in(const std::filesystem::path& path);

// Reads a folder, even while a run is writing to it. Only rows of `build` count; if `build` is
// empty, the folder may have rows of only one build. Throws InputError if `build` is empty and
// there are rows of several builds, or if the folder is not a results folder. Also throws like
// sort_rows().
ResultFolder open_results(const std::filesystem::path& path, const std::string& build = {});

// The existing files of a results folder: effective.yaml, the files with rows and the files with
// results.
std::vector<std::string> files_of_results(const std::filesystem::path& path);

// Throws InputError if results would overwrite files that are not the folder's own: it has
// effective.yaml or results.csv, but no subfolder with rows.
void refuse_files_without_rows(const std::filesystem::path& path);

// results.csv: the rows that count, sorted by game id, without columns that may differ from run to
// run.
std::string results_csv(const RowFormat& format, const RowsById& rows);

// CRC-32 of results.csv.
std::string rows_checksum(const ResultFolder& folder);

// Writes results.csv and the files of Experiment::results(). The same rows give the same files,
// byte for byte.
ExperimentResults write_results(const std::filesystem::path& folder, const Scenario& scenario,
                                const RowFormat& format, const RowsById& rows);

}  // namespace autoref::experiments
