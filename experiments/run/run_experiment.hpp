// Experiments: all games of a sweep, a round robin, an SPRT match and so on, played in worker
// processes and stored in a folder.
//
// The folder's primary data are games/*.csv, one row per game. Once all games have rows, the
// results are derived from them: results.csv (sorted by game id, without columns that may differ
// from run to run), summary.csv (per value, matchup or tie) and standings.csv (per team). If an
// SPRT match has games after the deciding pair, their rows are only in games/*.csv. effective.yaml
// is the scenario with every setting written out.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/results/shard.hpp"
#include "game/loop/game.hpp"
#include "io/processes/progress.hpp"

namespace autoref::experiments {

// How a run plays its games, and how it displays its results so far.
struct Outcomes {
  // Plays the game in a worker and fills the row's record (and evaluation). May throw.
  std::function<void(const game::GameConfiguration& game, GameRow& row)> play;
  std::function<io::ProgressView(const RowsById& rows)> view;  // displays the results so far
};

struct ExperimentOptions {
  std::filesystem::path folder;
  std::string build;  // build of this program; rows of other builds do not count
  int workers = 1;
  ShardIndex shard;                // only this shard's games are played
  bool allow_mixed_build = false;  // accept rows of other builds without counting them
  // Results folder whose games are taken over (reused_games.hpp), which may be missing. Empty: the
  // experiment's earlier folder if the same build played it, otherwise none.
  std::filesystem::path reused_folder = {};
  // Plays a game; called in workers.
  std::function<game::GameRecord(const game::GameConfiguration&)> play;
  std::optional<Outcomes> outcomes = {};  // replaces `play`; then no results are written
  std::FILE* progress = nullptr;          // no progress output if null
  io::ProgressStyle style = io::ProgressStyle::kAuto;  // style of the progress output
  io::Progress::Publish publish = {};                  // called with the progress
  // Gets the results so far whenever they are computed for display.
  std::function<void(const ExperimentResults& results)> show = {};
  std::function<void(const ScheduledGame& game)> starting = {};  // called before each game
  std::function<void(const GameRow& row)> ended = {};  // called once the game's row is on the disk
  double longest_game_s = 600;                         // wall-clock limit; longer games are void
  int attempts = 3;       // a game is void if its worker dies this many times
  double patience_s = 2;  // how long to wait while another run locks the shard
  // How long to wait for rows of other shards on which the next games depend. The time starts again
  // with each such row.
  double wait_s = 0;
};

struct ExperimentReport {
  // Whether all games have been played, including those of other shards.
  bool is_complete = false;
  // Whether the user interrupted the run before this shard's last game.
  bool is_interrupted = false;
  // Whether the next games depend on games that other shards must play first.
  bool is_waiting = false;
  int games = 0;   // number of games needed, as currently known
  int done = 0;    // number of games played by this run and earlier ones
  int played = 0;  // number of games played by this run
  int void_games = 0;
  int killed_games = 0;                 // number of void games that the next run replays
  std::vector<std::string> rule_notes;  // rule_notes() (experiments/results/game_row.hpp)
  int unrepeatable_games = 0;  // number of games whose programs did not repeat their commands
  ExperimentResults results;   // the results, if the experiment is complete
};

// Plays the games that have no row yet (with the same id, configuration and build), and those that
// are void because their workers were killed. Throws InputError if the folder's rows do not belong
// to this scenario, its seed or this build. Throws InputOutputError if the folder cannot be
// written, and std::logic_error if two rows of the same game and build differ in a reproducible
// column.
ExperimentReport run_experiment(const Scenario& scenario, const ExperimentOptions& options);

}  // namespace autoref::experiments
