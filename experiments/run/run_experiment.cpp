#include "experiments/run/run_experiment.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>

#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/results/game_row.hpp"
#include "experiments/results/shard.hpp"
#include "experiments/run/earlier_versions.hpp"
#include "experiments/run/program_versions.hpp"
#include "experiments/run/result_folder.hpp"
#include "experiments/run/reused_games.hpp"
#include "experiments/run/run_games.hpp"
#include "game/settings/game_settings.hpp"
#include "io/csv.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/processes/progress.hpp"
#include "io/processes/worker_process.hpp"
#include "io/processes/workers.hpp"

namespace autoref::experiments {
namespace {

// The machine's network name, or "unknown".
std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

// The processor's model name as Linux reports it; "unknown" on other systems.
std::string cpu_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

using Clock = std::chrono::steady_clock;

// For experiments with teams: their rows store the games' records.
Outcomes outcomes_of_records(const Scenario& scenario, const ExperimentOptions& options) {
  return {[&options](const game::GameConfiguration& game, GameRow& row) {
            row.record = options.play(game);
          },
          [&scenario, &options](const RowsById& rows) {
            ExperimentResults results = scenario.experiment().results(rows);
            if (options.show) options.show(results);
            const char* const heading =
                results.comparison ? "so far:"
                                   : "so far; do not stop early because of these intervals:";
            return io::ProgressView{heading, std::move(results.shown), std::move(results.json)};
          }};
}

// A game that throws is void immediately: games are deterministic, so it would throw again. A
// failure of the environment, however, is not a result of the game.
GameRow played(const Outcomes& outcomes, const ScheduledGame& game) {
  GameRow row = row_of(game);
  try {
    outcomes.play(resolved(game), row);
  } catch (const std::exception& error) {
    if (io::environment_failure(error)) throw;
    row.record = void_record(fmt::format("the game threw: {}", error.what()));
  }
  return row;
}

// Rows that end within this time of each other share one fdatasync, which takes milliseconds.
constexpr std::chrono::milliseconds kBetweenSyncs{100};

// Maximum fraction of the time spent rereading the folder.
constexpr double kLookingShare = 0.01;

// While waiting for other shards: the time between checks, which doubles each time, and the time
// before a message is printed.
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
        games_(scenario, options, format_),
        progress_(options.progress, options.style) {
    progress_.show([this] { return view_so_far(); });
    if (options.publish) progress_.publish(options.publish);
  }

  ExperimentReport run() {
    refuse_earlier_folder(scenario_.experiment(), options_.folder);
    refuse_files_without_rows(options_.folder);
    io::create_folder(options_.folder / kGamesFolder);
    // Lock the shard before reading the rows, so no other run of this shard can add rows
    // afterwards.
    shard_.emplace(options_.folder / kGamesFolder / options_.shard.file_name(),
                   io::csv_line(format_.names()), options_.patience_s);
    for (const std::string& note : games_.open()) progress_.say(note);
    if (const std::string note = note_on_taken_over(scenario_.experiment()); !note.empty())
      progress_.say(note);
    // Write effective.yaml only after the rows have been checked: a row played with other settings
    // would have caused an exception.
    io::replace_file(options_.folder / kEffectiveFile, effective_text(scenario_));
    const std::filesystem::path reused =
        options_.reused_folder.empty()
            ? reusable_earlier_folder(scenario_.experiment(), options_.build)
            : options_.reused_folder;
    if (!reused.empty()) take_over_games(reused);
    progress_.expect(games_.counts());
    ExperimentReport report;
    report.is_interrupted = play_all(report.played) == io::Ending::kInterrupted;
    keep_file();
    if (report.is_interrupted) progress_.keep_tables();
    progress_.expect(games_.counts());
    sum_up(report);
    return report;
  }

 private:
  // Adds the rows of games that were already played in another folder, as if this run had played
  // them.
  void take_over_games(const std::filesystem::path& folder) {
    ReusableGames reusable = reusable_games(folder, games_to_play(), format_, options_.build);
    for (GameRow& row : reusable.rows) {
      copy_program_files(folder, options_.folder, row.game_id);
      row.circumstances.shard = options_.shard.name();
      shard_->write(format_.line(row));
    }
    shard_->sync();
    games_.reread();
    games_.update_schedule();
    games_.update_decision();
    progress_.say(reusable.note);
  }

  std::vector<ScheduledGame> games_to_play() const {
    std::vector<ScheduledGame> games;
    for (const std::size_t i : games_.missing()) games.push_back(games_.schedule().games[i]);
    return games;
  }

  void sum_up(ExperimentReport& report) {
    games_.drop_uncounted_rows();
    const Schedule& schedule = games_.schedule();
    const RowsById& rows = games_.rows();
    report.games = static_cast<int>(schedule.needed);
    report.done = static_cast<int>(rows.size());
    report.is_complete = report.done == report.games;
    for (const auto& [id, row] : rows) {
      report.void_games += is_void(row.record) ? 1 : 0;
      report.killed_games += is_killed(row) ? 1 : 0;
      report.unrepeatable_games += row.record.is_repeatable.value_or(true) ? 0 : 1;
    }
    report.rule_notes = rule_notes(rows);
    report.is_waiting = schedule.needed > schedule.games.size() && !report.is_interrupted;
    if (report.is_complete && !options_.outcomes)
      report.results = write_results(options_.folder, scenario_, format_, rows);
  }

  // Rereads the folder, since other shards may have played games in the meantime.
  void look_at_other_shards() {
    keep_file();
    const Clock::time_point began = Clock::now();
    games_.reread();
    const Clock::duration looking = Clock::now() - began;
    next_look_ =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(looking / kLookingShare);
  }

  // Plays until every needed game of this shard that is already known has a row. Terminates because
  // every round except the last adds rows.
  io::Ending play_all(int& played_games) {
    while (true) {
      const std::vector<std::size_t> missing = games_.missing();
      if (missing.empty()) {
        const Waited waited = wait_for_others();
        if (waited == Waited::kInterrupted) return io::Ending::kInterrupted;
        if (waited == Waited::kGaveUp) return io::Ending::kDone;
        continue;
      }
      const io::Ending ending = play(missing, played_games);
      if (options_.shard.of > 1) look_at_other_shards();
      games_.update_schedule();
      progress_.expect(games_.counts());
      if (ending == io::Ending::kInterrupted && !games_.missing().empty()) return ending;
    }
  }

  enum class Waited { kForRows, kGaveUp, kInterrupted };

  // Waits until other shards have added rows, but at most wait_s.
  Waited wait_for_others() {
    if (options_.wait_s <= 0 || !games_.depends_on_others()) return Waited::kGaveUp;
    io::EndSignals signals;
    const Clock::time_point began = Clock::now();
    const auto waited_s = [began] {
      return std::chrono::duration<double>(Clock::now() - began).count();
    };
    const std::size_t rows = games_.rows().size();
    bool is_silent = true;
    for (int pause_ms = kShortestPause_ms; waited_s() < options_.wait_s;
         pause_ms = std::min(2 * pause_ms, kLongestPause_ms)) {
      pollfd signal{signals.descriptor(), POLLIN, 0};
      poll(&signal, 1, pause_ms);
      if (signals.count() > 0) return Waited::kInterrupted;
      look_at_other_shards();
      if (games_.rows().size() > rows) {
        games_.update_schedule();
        progress_.expect(games_.counts());
        return Waited::kForRows;
      }
      if (is_silent && waited_s() > kSilentWait_s) {
        progress_.say(fmt::format("shard {} is waiting for games of other shards, for at most {}",
                                  options_.shard.name(), io::duration_text(options_.wait_s)));
        is_silent = false;
      }
      progress_.tick();
    }
    return Waited::kGaveUp;
  }

  io::ProgressView view_so_far() const {
    if (!scenario_.experiment().follows_its_rows())
      return outcomes_.view(games_.rows());  // all rows count
    return outcomes_.view(games_.counted_rows());
  }

  void announce_ending(int running) {
    progress_.say(fmt::format(
        "interrupted: waiting for {} running games; press Ctrl-C again to stop immediately",
        running));
  }

  io::Ending play(const std::vector<std::size_t>& games, int& played_games) {
    const io::WorkerOptions workers{options_.workers, options_.attempts, options_.longest_game_s};
    std::function<bool()> is_enough;
    if (scenario_.experiment().may_end_within_a_round())
      is_enough = [this] { return games_.is_decided(); };
    const io::WorkerCalls calls{[this](const io::Job& job) { return played_line(job); },
                                [&](const io::JobResult& result) {
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
                                  if (options_.starting)
                                    options_.starting(games_.schedule().games[i]);
                                }};
    try {
      const io::Ending ending = io::do_jobs(games, workers, calls);
      count_written();
      return ending;
    } catch (const io::EnvironmentError& error) {
      keep_file();
      count_written();
      throw io::InputOutputError(
          fmt::format("{}; the games played so far are kept; repeat the command to play the others",
                      error.what()));
    }
  }

  // Workers make the final lines of their games; the main process appends them unchanged.
  std::string played_line(const io::Job& job) const {
    const Clock::time_point began = Clock::now();
    GameRow row = played(outcomes_, games_.schedule().games[job.number]);
    const std::chrono::duration<double> wall = Clock::now() - began;
    return line_of(std::move(row), wall.count(), job.attempt);
  }

  // The line for a game that took too long or lost its workers.
  std::string failed_line(const io::JobResult& result) const {
    GameRow row = row_of(games_.schedule().games[result.job]);
    row.record = void_record(result.failure);
    return line_of(std::move(row), result.wall_s, result.attempt);
  }

  // `attempt` counts the workers that played the game. Within one attempt, the game's programs may
  // have been started several times.
  std::string line_of(GameRow row, double wall_s, int attempt) const {
    row.circumstances = {
        options_.build,       host_, cpu_, wall_s, attempt + row.record.attempts - 1,
        options_.shard.name()};
    return format_.line(row);
  }

  // Throws std::logic_error if the worker sent anything other than a row.
  void keep(const io::JobResult& result) {
    const std::string line = result.failure.empty() ? result.payload : failed_line(result);
    std::optional<GameRow> row = format_.read(line);
    if (!row) throw std::logic_error("a worker's answer is not a row: " + line);
    refuse_changed_programs();
    keep_file();
    shard_->write(line);
    written_.push_back(std::move(*row));
    // No further games may be needed after this one.
    if (scenario_.experiment().may_end_within_a_round() || Clock::now() >= next_sync_)
      count_written();
  }

  // It is unknown whether the old or the new version of the program played the game.
  void refuse_changed_programs() {
    const std::vector<std::string> changed = programs_.changed_settings();
    if (changed.empty()) return;
    throw io::InputError(
        {}, changed.front(),
        fmt::format(
            "a file of the program was changed during the run; the games played before that are "
            "kept; play games of the new version in another folder, with -o instead of {}",
            options_.folder.string()));
  }

  // Another program may have replaced, moved, shortened or removed the file or its folder.
  void keep_file() {
    if (shard_->is_intact()) return;
    std::vector<std::string> lines;
    for (const auto& [id, row] : games_.rows()) {
      if (row.circumstances.shard == options_.shard.name()) lines.push_back(format_.line(row));
    }
    for (const GameRow& row : written_) lines.push_back(format_.line(row));
    shard_->restore(lines);
    io::replace_file(options_.folder / kEffectiveFile, effective_text(scenario_));
    progress_.say(
        fmt::format("{} was replaced, moved, shortened or removed while this run was writing it; "
                    "this experiment's rows have been restored",
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
    if (options_.shard.of > 1 && Clock::now() >= next_look_) look_at_other_shards();
    games_.update_decision();
  }

  void count(GameRow row) {
    const std::string& reason = row.record.void_reason;
    if (!reason.empty()) progress_.say(fmt::format("{} is void: {}", row.game_id, reason));
    if (options_.ended) options_.ended(row);
    const bool is_void_game = is_void(row.record);
    games_.add(std::move(row));
    progress_.game_done(is_void_game);  // may display the rows
  }

  const Scenario& scenario_;
  const ExperimentOptions& options_;
  const RowFormat format_;
  const Outcomes outcomes_;
  RunGames games_;  // their schedule is unchanged while workers play
  ProgramChanges programs_{scenario_};
  const std::string host_ = host_name();
  const std::string cpu_ = cpu_name();
  std::optional<Shard> shard_;  // locked during run()
  Clock::time_point next_look_;
  Clock::time_point next_sync_;   // before then, rows are written but not synced
  std::vector<GameRow> written_;  // played, but not yet counted
  io::Progress progress_;         // last, so destroyed first: it displays the other members
};

}  // namespace

ExperimentReport run_experiment(const Scenario& scenario, const ExperimentOptions& options) {
  return ExperimentRun(scenario, options).run();
}

}  // namespace autoref::experiments
