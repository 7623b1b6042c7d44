#include "runner/batch/experiment.hpp"
#include "runner/experiments/kinds/effective.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <stdexcept>

#include "runner/batch/completed_games.hpp"
#include "runner/batch/folder_changes.hpp"
#include "runner/batch/program_versions.hpp"
#include "runner/batch/result_folder.hpp"
#include "runner/io/csv.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/io/host.hpp"
#include "runner/processes/progress.hpp"
#include "runner/processes/worker_process.hpp"
#include "runner/processes/workers.hpp"
#include "runner/results/scores.hpp"
#include "runner/results/shard.hpp"
#include "runner/settings/resolved.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// For experiments with teams, where rows store the games' records.
Outcomes outcomes_of_records(const Scenario& scenario, const ExperimentOptions& options) {
  return {
      [&options](const GameConfiguration& game, GameRow& row) { row.record = options.play(game); },
      [&scenario, &options](const RowsById& rows) {
        ExperimentResults results = scenario.experiment().results(rows);
        if (options.show) options.show(results);
        return ProgressView{"so far; do not stop early because of these intervals:",
                            std::move(results.shown), std::move(results.json)};
      }};
}

// A game that throws is void at once: games are deterministic, so it would throw again. A failure
// of the environment is not a result of the game.
GameRow played(const Outcomes& outcomes, const ScheduledGame& game) {
  GameRow row = row_of(game);
  try {
    outcomes.play(resolved(game), row);
  } catch (const std::exception& error) {
    if (environment_failure(error)) throw;
    row.record = void_record(fmt::format("the game threw: {}", error.what()));
  }
  row.circumstances.attempt = row.record.attempts;
  return row;
}

// Rows that end within this time of each other share one fdatasync, which takes milliseconds.
constexpr std::chrono::milliseconds kBetweenSyncs{100};

// Maximum fraction of the time spent rereading the folder.
constexpr double kLookingShare = 0.01;

// While waiting for other shards: time between looks, which doubles, and time before a message.
constexpr int kShortestPause_ms = 20;
constexpr int kLongestPause_ms = 1000;
constexpr double kSilentWait_s = 10;

class ExperimentRun {
 public:
  ExperimentRun(const Scenario& scenario, const ExperimentOptions& options)
      : scenario_(scenario),
        options_(options),
        format_(row_format(scenario.experiment())),
        outcomes_(options.outcomes ? *options.outcomes : outcomes_of_records(scenario, options)),
        there_(scenario_of_folder(options.folder)),
        progress_(options.progress, options.style) {
    progress_.show([this] { return view_so_far(); });
    if (options.publish) progress_.publish(options.publish);
  }

  ExperimentReport run() {
    create_folder(options_.folder / kGamesFolder);
    // Lock the shard before reading the rows, so no other run of this shard can add rows
    // afterwards.
    shard_.emplace(options_.folder / kGamesFolder / options_.shard.file_name(),
                   csv_line(format_.names()), options_.patience_s);
    take_with_notes();
    set_killed_games_aside();
    is_decided_ = scenario_.experiment().is_decided(rows_);
    // Written only now: the rows have been checked, and a row played with other settings would have
    // thrown.
    replace_file(options_.folder / kEffectiveFile, effective_text(scenario_));
    progress_.expect(counts());
    ExperimentReport report;
    report.is_interrupted = play_all(report.played) == Ending::kInterrupted;
    keep_file();
    if (report.is_interrupted) progress_.keep_tables();
    progress_.expect(counts());
    rows_ = counted(schedule_, std::move(rows_));
    report.games = static_cast<int>(schedule_.needed);
    report.done = static_cast<int>(rows_.size());
    report.is_complete = report.done == report.games;
    for (const auto& [id, row] : rows_) {
      report.void_games += is_void(row.record) ? 1 : 0;
      report.killed_games += is_killed(row) ? 1 : 0;
      report.unrepeatable_games += row.record.is_repeatable.value_or(true) ? 0 : 1;
    }
    report.is_waiting = schedule_.needed > schedule_.games.size() && !report.is_interrupted;
    if (report.is_complete && !options_.outcomes) conclude(report);
    return report;
  }

 private:
  RowInventory take(RowsInFiles rows) const {
    return take_row_inventory(scenario_, std::move(rows), format_, options_.build,
                              options_.allow_mixed_build, options_.folder, changes());
  }

  void take_with_notes() {
    StoredRows stored = read_rows(options_.folder / kGamesFolder, format_);
    const bool has_rows = !stored.rows.empty();
    if (there_ && has_rows) refuse_other_seed(scenario_, *there_, options_.folder);
    RowInventory row_inventory = take(std::move(stored.rows));
    schedule_ = std::move(row_inventory.schedule);
    rows_ = std::move(row_inventory.completed_games.done);
    if (!stored.damaged.empty() && !missing_games().empty()) {
      progress_.say(fmt::format(
          "damaged rows that do not count: {}, the first at {}; their games will be replayed",
          stored.damaged.size(), stored.damaged.front().at));
    }
    note_other_games(row_inventory.completed_games.other_games, has_rows);
    for (const auto& [build, count] : row_inventory.completed_games.other_builds) {
      progress_.say(fmt::format("{} rows are from build {}; they do not count", count, build));
    }
  }

  void note_other_games(int count, bool has_rows) {
    const std::string pairs =
        there_ && has_rows ? note_on_pairs(scenario_, *there_, count) : std::string();
    if (!pairs.empty()) return progress_.say(pairs);
    if (count == 0) return;
    progress_.say(fmt::format(
        "{} rows belong to games that are not in the scenario; they do not count", count));
  }

  // Every run replays the games that are void because their workers were killed.
  void set_killed_games_aside() {
    for (const ScheduledGame& game : schedule_.games) {
      const auto row = rows_.find(game.id);
      if (row == rows_.end() || !has(game)) continue;
      if (is_killed(row->second)) again_.insert(game.id);
    }
    for (const std::string& id : again_) rows_.erase(id);
    if (again_.empty()) return;
    progress_.say(
        fmt::format("{} games are void because their workers were killed; they are "
                    "replayed",
                    again_.size()));
    schedule_ = scenario_.experiment().schedule(rows_);
  }

  // Rereads the folder, since other shards may have played games in the meantime.
  void look_around() {
    keep_file();
    const Clock::time_point began = Clock::now();
    rows_ = take(read_rows(options_.folder / kGamesFolder, format_).rows).completed_games.done;
    for (const std::string& id : again_) rows_.erase(id);
    const Clock::duration looking = Clock::now() - began;
    next_look_ =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(looking / kLookingShare);
  }

  // Differences from the scenario the folder was created with; empty if that is unknown.
  std::string changes() const {
    return there_ ? changes_between(scenario_.experiment(), there_->experiment()) : std::string();
  }

  // Plays until every needed game of this shard that is already known has a row. Terminates because
  // every round except the last adds rows.
  Ending play_all(int& played_games) {
    while (true) {
      const std::vector<std::size_t> missing = missing_games();
      if (missing.empty()) {
        const Waited waited = wait_for_others();
        if (waited == Waited::kInterrupted) return Ending::kInterrupted;
        if (waited == Waited::kInVain) return Ending::kDone;
        continue;
      }
      const Ending ending = play(missing, played_games);
      if (options_.shard.of > 1) look_around();
      if (scenario_.experiment().follows_its_rows())
        schedule_ = scenario_.experiment().schedule(rows_);
      progress_.expect(counts());
      if (ending == Ending::kInterrupted && !missing_games().empty()) return ending;
    }
  }

  enum class Waited { kForRows, kInVain, kInterrupted };

  // Whether games that are known, but belong to other shards, are missing before the next ones are
  // known.
  bool depends_on_others() const {
    if (options_.shard.of == 1 || schedule_.needed <= schedule_.games.size()) return false;
    return std::any_of(schedule_.games.begin(), schedule_.games.end(),
                       [this](const ScheduledGame& game) { return !rows_.contains(game.id); });
  }

  // Waits until other shards have added rows, at most for wait_s.
  Waited wait_for_others() {
    if (options_.wait_s <= 0 || !depends_on_others()) return Waited::kInVain;
    EndSignals signals;
    const Clock::time_point began = Clock::now();
    const auto waited_s = [began] {
      return std::chrono::duration<double>(Clock::now() - began).count();
    };
    const std::size_t rows = rows_.size();
    bool is_silent = true;
    for (int pause_ms = kShortestPause_ms; waited_s() < options_.wait_s;
         pause_ms = std::min(2 * pause_ms, kLongestPause_ms)) {
      pollfd signal{signals.descriptor(), POLLIN, 0};
      poll(&signal, 1, pause_ms);
      if (signals.count() > 0) return Waited::kInterrupted;
      look_around();
      if (rows_.size() > rows) {
        schedule_ = scenario_.experiment().schedule(rows_);
        progress_.expect(counts());
        return Waited::kForRows;
      }
      if (is_silent && waited_s() > kSilentWait_s) {
        progress_.say(fmt::format("shard {} waits for games of other shards, at most {}",
                                  options_.shard.name(), duration_text(options_.wait_s)));
        is_silent = false;
      }
      progress_.tick();
    }
    return Waited::kInVain;
  }

  bool has(const ScheduledGame& game) const { return options_.shard.has(game.unit, game.variants); }

  std::vector<std::size_t> missing_games() const {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < std::min(schedule_.needed, schedule_.games.size()); ++i) {
      const ScheduledGame& game = schedule_.games[i];
      if (has(game) && !rows_.contains(game.id)) missing.push_back(i);
    }
    return missing;
  }

  // Counts this shard's needed games, and all games that are not known yet.
  GameCounts counts() const {
    const std::size_t known = std::min(schedule_.needed, schedule_.games.size());
    GameCounts counts{.total = static_cast<int>(schedule_.needed - known), .voids = 0};
    for (std::size_t i = 0; i < known; ++i) {
      const ScheduledGame& game = schedule_.games[i];
      if (!has(game)) continue;
      const auto row = rows_.find(game.id);
      ++counts.total;
      counts.done += row == rows_.end() ? 0 : 1;
      *counts.voids += row != rows_.end() && is_void(row->second.record) ? 1 : 0;
    }
    return counts;
  }

  ProgressView view_so_far() const {
    if (!scenario_.experiment().follows_its_rows())
      return outcomes_.view(rows_);  // all of them count
    return outcomes_.view(counted(schedule_, rows_));
  }

  void announce_ending(int running) {
    progress_.say(
        fmt::format("interrupted: waiting for {} running games; press Ctrl-C again to stop at "
                    "once",
                    running));
  }

  Ending play(const std::vector<std::size_t>& games, int& played_games) {
    const WorkerOptions workers{options_.workers, options_.attempts, options_.longest_game_s};
    std::function<bool()> is_enough;
    if (scenario_.experiment().follows_its_rows()) is_enough = [this] { return is_decided_; };
    const WorkerCalls calls{
        [this](std::size_t i) { return format_.line(played(outcomes_, schedule_.games[i])); },
        [&](const JobResult& result) {
          keep(result);
          ++played_games;
        },
        [&] {
          if (Clock::now() >= next_sync_) count_written();
          progress_.tick();
        },
        is_enough,
        [this](int running) { announce_ending(running); },
        [this](std::size_t i) {
          if (options_.starting) options_.starting(schedule_.games[i]);
        }};
    try {
      const Ending ending = do_jobs(games, workers, calls);
      count_written();
      return ending;
    } catch (const EnvironmentError& error) {
      keep_file();
      count_written();
      throw InputOutputError(
          fmt::format("{}; the games played so far are kept, and the same command plays the others",
                      error.what()));
    }
  }

  // Throws std::logic_error if the worker sent anything other than a row.
  GameRow row_from(const JobResult& result) const {
    if (!result.failure.empty()) {
      GameRow row = row_of(schedule_.games[result.job]);
      row.record = void_record(result.failure);
      return row;
    }
    std::optional<GameRow> row = format_.read(result.payload);
    if (!row) throw std::logic_error("a worker's answer is not a row: " + result.payload);
    return std::move(*row);
  }

  void keep(const JobResult& result) {
    GameRow row = row_from(result);
    const int attempt = result.attempt + row.circumstances.attempt - 1;  // of worker and programs
    row.circumstances = {options_.build, host_,   cpu_,
                         result.wall_s,  attempt, options_.shard.name()};
    refuse_changed_programs();
    keep_file();
    shard_->write(format_.line(row));
    written_.push_back(std::move(row));
    // The next games may depend on this one.
    if (scenario_.experiment().follows_its_rows() || Clock::now() >= next_sync_) count_written();
  }

  // Whether the game was played by the former or the new version is not known.
  void refuse_changed_programs() {
    const std::vector<std::string> changed = programs_.changed_settings();
    if (changed.empty()) return;
    throw InputError({}, changed.front(),
                     fmt::format("a file of the program was changed during the run; the games "
                                 "played before are kept; play those of the new version in another "
                                 "folder, with -o instead of {}",
                                 options_.folder.string()));
  }

  // Another program may have replaced, moved, shortened or removed the file or its folder.
  void keep_file() {
    if (shard_->is_intact()) return;
    std::vector<std::string> lines;
    for (const auto& [id, row] : rows_) {
      if (row.circumstances.shard == options_.shard.name()) lines.push_back(format_.line(row));
    }
    for (const GameRow& row : written_) lines.push_back(format_.line(row));
    shard_->restore(lines);
    replace_file(options_.folder / kEffectiveFile, effective_text(scenario_));
    progress_.say(
        fmt::format("{} was replaced, moved, shortened or removed while this run was writing it; "
                    "the rows of this experiment "
                    "are there again",
                    (options_.folder / kGamesFolder / options_.shard.file_name()).string()));
  }

  // Games count only once their rows are on the disk, so a game shown as done is never lost.
  void count_written() {
    if (written_.empty()) return;
    keep_file();
    shard_->sync();
    next_sync_ = Clock::now() + kBetweenSyncs;
    for (GameRow& row : written_) count(std::move(row));
    written_.clear();
    if (!scenario_.experiment().follows_its_rows()) return;
    if (options_.shard.of > 1 && Clock::now() >= next_look_) look_around();
    is_decided_ = scenario_.experiment().is_decided(rows_);
  }

  void count(GameRow row) {
    const std::string& reason = row.record.void_reason;
    if (!reason.empty()) progress_.say(fmt::format("{} is void: {}", row.game_id, reason));
    again_.erase(row.game_id);
    if (options_.ended) options_.ended(row);
    const bool is_void_game = is_void(row.record);
    const std::string id = row.game_id;
    rows_[id] = std::move(row);
    progress_.game_done(is_void_game);  // may display the rows
  }

  void conclude(ExperimentReport& report) const {
    report.results = write_results(options_.folder, scenario_, format_, rows_);
  }

  const Scenario& scenario_;
  const ExperimentOptions& options_;
  const RowFormat format_;
  const Outcomes outcomes_;
  ProgramWatch programs_{scenario_};
  const std::string host_ = host_name();
  const std::string cpu_ = cpu_name();
  std::optional<Shard> shard_;   // locked during run()
  Schedule schedule_;            // unchanged while workers play
  RowsById rows_;                // of scheduled games, including those that are not needed
  std::set<std::string> again_;  // ids of killed games still to be replayed
  bool is_decided_ = false;
  Clock::time_point next_look_;
  Clock::time_point next_sync_;          // before then, rows are written, but not synced
  std::vector<GameRow> written_;         // played, but not yet counted
  const std::optional<Scenario> there_;  // the scenario of earlier runs in this folder
  Progress progress_;                    // last, so destroyed first: it displays the other members
};

}  // namespace

ExperimentReport run_experiment(const Scenario& scenario, const ExperimentOptions& options) {
  return ExperimentRun(scenario, options).run();
}

}  // namespace autoref::runner
