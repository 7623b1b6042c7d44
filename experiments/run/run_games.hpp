// The games of a run of an experiment, those of them that have rows, and how the experiment differs
// from the folder it continues in.
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

// "the folder had 6 pairs, now 12; its games count, and only the new ones are played"; empty if the
// number has not changed. `beyond` is the number of rows whose games are not in the scenario, or
// not known to be yet.
std::string note_on_pairs(const Scenario& here, const Scenario& there, int beyond);

// Knows which games there are and which of them have rows, from this run, earlier ones and other
// shards. Plays and writes nothing; the run (run_experiment()) asks it what to play next.
class RunGames {
 public:
  // All must outlive it.
  RunGames(const Scenario& scenario, const ExperimentOptions& options, const RowFormat& format);

  // Reads the rows of earlier runs and of other shards. Sets aside the games that are void because
  // their workers were killed: every run replays them. Returns lines that say which rows do not
  // count, and why. Throws InputError if the rows do not belong to this scenario, its seed or this
  // build.
  std::vector<std::string> open();

  // Reads them again, since other shards may have played games in the meantime. Leaves the schedule
  // as it is. Throws like open().
  void reread();

  // A game has been played, and its row is on the disk.
  void add(GameRow row);

  // Computes the schedule again, if it depends on the rows.
  void update_schedule();
  // Computes is_decided() again.
  void update_decision();

  const Schedule& schedule() const { return schedule_; }
  // Of scheduled games, including those that are not needed until drop_uncounted_rows().
  const RowsById& rows() const { return rows_; }
  // Of the games that are needed.
  RowsById counted_rows() const { return needed_rows(schedule_, rows_); }
  // Keeps only those.
  void drop_uncounted_rows() { rows_ = needed_rows(schedule_, std::move(rows_)); }
  bool is_decided() const { return is_decided_; }

  // Indices into schedule().games: this shard's needed games without a row, as far as they are
  // known.
  std::vector<std::size_t> missing() const;
  // Counts this shard's needed games, and all games that are not known yet.
  io::GameCounts counts() const;
  // Whether games that are known, but belong to other shards, are missing before the next ones are
  // known.
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
  const std::string changes_;             // since then; empty if it is unknown
  Schedule schedule_;
  RowsById rows_;
  std::set<std::string> to_replay_;  // ids of killed games still to be replayed
  bool is_decided_ = false;
};

}  // namespace autoref::experiments
