#include "runner/experiment.hpp"

#include <fmt/format.h>

#include <map>
#include <numeric>

#include "runner/csv.hpp"
#include "runner/errors.hpp"
#include "runner/files.hpp"
#include "runner/plan.hpp"
#include "runner/progress.hpp"
#include "runner/result_folder.hpp"
#include "runner/shard.hpp"
#include "runner/stock.hpp"
#include "runner/workers.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

GameRecord void_record(const std::string& reason) {
  GameRecord record;
  record.status = Status::kVoid;
  record.end_reason = EndReason::kVoid;
  record.void_reason = reason;
  return record;
}

// A game that throws goes the same way each time: it is void at once.
std::string played(const ExperimentOptions& options, const GameConfiguration& configuration) {
  try {
    return csv_line(outcome_of(options.play(configuration)));
  } catch (const std::exception& error) {
    return csv_line(outcome_of(void_record(fmt::format("the game threw: {}", error.what()))));
  }
}

class Experiment {
 public:
  Experiment(const Scenario& scenario, const ExperimentOptions& options)
      : scenario_(scenario),
        options_(options),
        format_(value_columns(scenario)),
        games_(plan_of(scenario, options.folder)) {}

  ExperimentReport run() {
    create_folder(options_.folder / kGamesFolder);
    Shard shard(options_.folder / kGamesFolder / options_.shard.file_name(),
                csv_line(format_.columns()), options_.patience_s);
    take_with_notes();
    replace_file(options_.folder / kEffectiveFile, effective_text(scenario_));
    ExperimentReport report;
    report.games = static_cast<int>(games_.size());
    report.is_interrupted = play_missing(shard, report.played) == Ending::kInterrupted;
    if (options_.shard.of > 1) rows_ = take().done;  // others may have played meanwhile
    report.is_complete = rows_.size() == games_.size();
    report.done = static_cast<int>(rows_.size());
    for (const auto& [id, cells] : rows_) {
      report.void_games += cells[format_.column("status")] == name_of(Status::kVoid) ? 1 : 0;
    }
    if (report.is_complete) conclude(report);
    return report;
  }

 private:
  Stock take() const { return take(read_rows(options_.folder / kGamesFolder, format_)); }

  Stock take(const StoredRows& stored) const {
    return take_stock(stored.rows, games_, format_, options_.build, options_.allow_mixed_build,
                      options_.folder, changes());
  }

  void take_with_notes() {
    const StoredRows stored = read_rows(options_.folder / kGamesFolder, format_);
    Stock stock = take(stored);
    rows_ = std::move(stock.done);
    if (stored.damaged > 0) {
      say(fmt::format("{} rows are damaged and do not count; their games are played again",
                      stored.damaged));
    }
    if (stock.other_games > 0) {
      say(fmt::format("{} rows belong to games that the scenario does not have; they do not count",
                      stock.other_games));
    }
    for (const auto& [build, count] : stock.other_builds) {
      say(fmt::format("{} rows are of build {}; they do not count", count, build));
    }
  }

  // What differs from the scenario that the folder was made with, as far as it can be told.
  std::string changes() const {
    const fs::path file = options_.folder / kEffectiveFile;
    try {
      const std::optional<std::string> text = read_file(file);
      if (!text) return {};
      return changes_between(scenario_, read_scenario_text(*text, file.string()));
    } catch (const InputError&) {
      return {};
    }
  }

  Ending play_missing(Shard& shard, int& played_games) {
    std::vector<std::size_t> missing;
    for (std::size_t i = 0; i < games_.size(); ++i) {
      if (options_.shard.has(i) && !rows_.contains(games_[i].id)) missing.push_back(i);
    }
    if (missing.empty()) return Ending::kDone;
    Progress progress(options_.progress, static_cast<int>(games_.size()),
                      static_cast<int>(rows_.size()));
    const WorkerOptions workers{options_.workers, options_.attempts, options_.longest_game_s};
    return do_jobs(missing, workers,
                   {[this](std::size_t i) { return played(options_, games_[i].configuration); },
                    [&](const JobResult& result) {
                      keep(shard, result, progress);
                      ++played_games;
                    },
                    [&progress] { progress.tick(); }});
  }

  void keep(Shard& shard, const JobResult& result, Progress& progress) {
    const PlannedGame& game = games_[result.job];
    const Cells outcome = result.failure.empty() ? csv_cells(result.payload).value()
                                                 : outcome_of(void_record(result.failure));
    const std::string line = format_.line(
        game, outcome,
        {options_.build, host_, cpu_, result.wall_s, result.attempt, options_.shard.name()});
    shard.append(line);
    const Cells cells = format_.read(line).value();
    const std::string& reason = cells[format_.column("void_reason")];
    if (!reason.empty()) progress.say(fmt::format("{} is void: {}", game.id, reason));
    progress.game_done(fmt::format("{} {}:{}", game.id, cells[format_.column("goals_a")],
                                   cells[format_.column("goals_b")]));
    rows_[game.id] = cells;
  }

  void conclude(ExperimentReport& report) const {
    report.results = write_results(options_.folder, scenario_, format_, rows_);
    std::vector<Cells> rows;
    for (const auto& [id, cells] : rows_) rows.push_back(cells);
    report.arrows_never_taken = arrows_never_taken(format_, rows);
  }

  void say(const std::string& message) const {
    if (options_.progress != nullptr) tell(options_.progress, message + "\n");
  }

  const Scenario& scenario_;
  const ExperimentOptions& options_;
  const RowFormat format_;
  const std::vector<PlannedGame> games_;
  const std::string host_ = host_name();
  const std::string cpu_ = cpu_name();
  std::map<std::string, Cells> rows_;  // complete rows of the games, by id
};

}  // namespace

ExperimentReport run_experiment(const Scenario& scenario, const ExperimentOptions& options) {
  return Experiment(scenario, options).run();
}

}  // namespace autoref::runner
