// A folder of results, as `autoref run` and `autoref judge` fill it: what was to be played, and
// what has been.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "runner/batch/completed_games.hpp"
#include "runner/batch/experiment_kinds.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/experiments/schedule.hpp"
#include "runner/results/row_format.hpp"

namespace autoref::runner {

struct ResultFolder {
  std::filesystem::path path;
  Scenario scenario;  // of effective.yaml
  RowFormat format;
  std::vector<ScheduledGame> games;     // that it takes, as far as they are known
  std::size_t needed = 0;               // how many of them, from the first
  std::string build;                    // whose rows count
  CompletedGames completed_games;       // its `done` holds only what counts
  int beyond = 0;                       // rows of games that turned out not to be needed
  int damaged = 0;                      // rows that do not count
  std::map<std::string, int> by_shard;  // how many games each has played, "0/1"

  int void_games() const;
  int killed_games() const;  // void ones that the next run plays again
  bool is_complete() const { return completed_games.done.size() == needed; }
};

// The scenario that the folder's rows belong to. Throws InputError where the folder is none of
// results.
Scenario scenario_in(const std::filesystem::path& folder);

// Whose rows a folder holds. Throws InputError where the folder is none of results.
std::set<std::string> builds_in(const std::filesystem::path& path);

// Reads a folder, whether or not a run is still filling it. Only rows of one build count: of
// `build`, or where that is empty of the only one that there is. Throws InputError where the folder
// is none of results, where several builds' rows leave the choice open, and what sort_rows()
// throws.
ResultFolder open_results(const std::filesystem::path& path, const std::string& build = {});

// The files by which a folder of results is known, as far as they are there: what it was made from,
// its rows, and what follows from them.
std::vector<std::string> files_of_results(const std::filesystem::path& path);

// results.csv: the rows that count, sorted by game and without what may differ from run to run.
std::string results_csv(const RowFormat& format, const RowsById& rows);

// Writes what follows from the rows: results.csv, sorted by game and without what may differ from
// run to run, and the files of results_of(). The same rows give the same files, byte by byte.
ExperimentResults write_results(const std::filesystem::path& folder, const Scenario& scenario,
                                const RowFormat& format, const RowsById& rows);

}  // namespace autoref::runner
