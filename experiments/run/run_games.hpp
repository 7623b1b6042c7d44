// The games of an experiment's run, which of them have rows, and how the experiment differs from
// the folder in which it continues.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "experiments/results/row_format.hpp"
#include "experiments/results/shard.hpp"
#include "experiments/run/completed_games.hpp"
#include "experiments/run/run_experiment.hpp"
#include "io/processes/progress.hpp"

namespace autoref::experiments {

// The scenario of the last run in a folder; nullopt if unknown.
std::optional<Scenario> scenario_of_folder(const std::filesystem::path& folder);

// Throws InputError, with advice on how to continue, if the folder's games have a different seed.
void refuse_other_seed(const Scenario& here, const Scenario& there,
                       const std::filesystem::path& folder);

// "the folder had 6 pairs, now 12; the games already played count, and only the others are played";
// empty if the number of pairs has not changed. `beyond` is the number of rows whose games are not
// in the scenario or not yet known to be in it.
std::string note_on_pairs(const Scenario& here, const Scenario& there, int beyond);

// Keeps track of the games and of their rows, which come from this run, from earlier runs and from
// other shards. This class neither plays nor writes anything; run_experiment() asks it which games
// to play next.
class RunGames {
 public:
  // All arguments must outlive this object.
  RunGames(const Scenario& scenario, const ExperimentOptions& options, const RowFormat& format);

  // Reads the rows of earlier runs and of other shards. Sets aside the games that are void because
  // their workers were killed: every run replays them. Returns lines of text that say which rows do
  // not count and why. Throws InputError if the rows do not belong to this scenario, its seed or
  // this build.
  std::vector<std::string> open();

  // Reads the rows again, since other shards may have played games in the meantime. Does not change
  // the schedule. Throws like open().
  void reread();

  // Adds a game that has been played, once its row is on the disk.
  void add(GameRow row);

  // Recomputes the schedule if it depends on the rows.
  void update_schedule();
  // Recomputes is_decided().
  void update_decision();

  const Schedule& schedule() const { return schedule_; }
  // Rows of scheduled games. Until drop_uncounted_rows() is called, they include rows of games that
  // are not needed.
  const RowsById& rows() const { return rows_; }
  // Rows of the needed games.
  RowsById counted_rows() const { return needed_rows(schedule_, rows_); }
  // Keeps only counted_rows().
  void drop_uncounted_rows() { rows_ = needed_rows(schedule_, std::move(rows_)); }
  bool is_decided() const { return is_decided_; }

  // Indices into schedule().games: the needed games of this shard that are known so far and have no
  // row.
  std::vector<std::size_t> missing() const;
  // The counts for this shard's needed games and for all games that are not known yet.
  io::GameCounts counts() const;
  // Whether the next games cannot be known until other shards have played some of theirs.
  bool depends_on_others() const;

 private:
  RowInventory inventory_of(RowsInFiles rows) const;
  void set_killed_games_aside(std::vector<std::string>& notes);
  std::string note_on_other_games(int count, bool has_rows) const;
  bool has(const ScheduledGame& game) const { return options_.shard.has(game.unit, game.variants); }

  const Scenario& scenario_;
  const ExperimentOptions& options_;
  const RowFormat& format_;
  const std::optional<Scenario> former_;  // the scenario of earlier runs in this folder
  // Changes of settings since that scenario; empty if it is unknown.
  const std::string changes_;
  Schedule schedule_;
  RowsById rows_;
  std::set<std::string> to_replay_;  // ids of killed games still to be replayed
  bool is_decided_ = false;
};

}  // namespace autoref::experiments
