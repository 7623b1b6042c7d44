// Experiments: all games of a sweep, a round robin, a match and so on, played in worker processes
// and kept in a folder.
//
// The folder holds the truth, a row per game in games/*.csv, and what follows from it when all
// games are there: results.csv (sorted by game id, without what may differ from run to run),
// summary.csv (per value, matchup or tie), standings.csv of teams. A match's games beyond the
// pair that decides it stay in games/*.csv alone. effective.yaml has the
// scenario with every setting spelt out.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "runner/batch/experiment_kinds.hpp"
#include "runner/batch/outcomes.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/game/game.hpp"
#include "runner/processes/progress.hpp"
#include "runner/results/shard.hpp"

namespace autoref::runner {

struct ExperimentOptions {
  std::filesystem::path folder;
  std::string build;  // of the rows to be written; rows of others do not count
  int workers = 1;
  ShardIndex shard;                // plays its share of the games only
  bool allow_mixed_build = false;  // rows of other builds may stand in the folder; they stay apart
  std::function<GameRecord(const GameConfiguration&)> play;  // called in workers
  std::optional<Outcomes> outcomes = {};       // instead of what `play` comes to; write no results
  std::FILE* progress = nullptr;               // where to write progress, if anywhere
  ProgressStyle style = ProgressStyle::kAuto;  // and how
  double longest_game_s = 600;                 // wall time, then it is void
  int attempts = 3;                            // for a game whose worker dies, until it is void
  double patience_s = 2;                       // for another run to let go of the folder
};

struct ExperimentReport {
  bool is_complete = false;     // all games are there, also those of other shards
  bool is_interrupted = false;  // by the user, with games of this shard left
  bool is_waiting = false;      // later games follow from some that other shards have to play
  int games = 0;                // that it takes, as far as is known
  int done = 0;                 // so far, by this run and former ones
  int played = 0;               // by this run
  int void_games = 0;
  int killed_games = 0;                             // of them, those that the next run plays again
  ExperimentResults results;                        // of a complete run
  std::vector<std::string> transitions_never_used;  // of the referee's machine, by a complete run
};

// Plays the games that have no row yet: none with the same id, configuration and build; and those
// that are void because their workers were killed. Throws InputError where the folder's rows do not
// belong to this scenario, its seed or this build, InputOutputError where it cannot be written, and
// std::logic_error where two rows of one game and build differ in what must be reproducible.
ExperimentReport run_experiment(const Scenario& scenario, const ExperimentOptions& options);

}  // namespace autoref::runner
