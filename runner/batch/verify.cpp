#include "runner/batch/verify.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runner/io/csv.hpp"
#include "runner/io/errors.hpp"
#include "runner/processes/progress.hpp"
#include "runner/processes/workers.hpp"

namespace autoref::runner {
namespace {

// Places in the plan of games with good rows.
std::vector<std::size_t> good_games(const ResultFolder& folder) {
  const std::size_t status = folder.format.column("status");
  std::vector<std::size_t> good;
  for (std::size_t i = 0; i < folder.games.size(); ++i) {
    const auto row = folder.completed_games.done.find(folder.games[i].id);
    if (row != folder.completed_games.done.end() && row->second[status] == name_of(Status::kOk))
      good.push_back(i);
  }
  return good;
}

std::vector<std::size_t> spread_evenly(const std::vector<std::size_t>& all, int count) {
  const std::size_t wanted = std::min(all.size(), static_cast<std::size_t>(count));
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(all[i * all.size() / wanted]);
  return chosen;
}

void compare(const ResultFolder& folder, const std::string& id, const Cells& outcome,
             std::vector<Difference>& differences) {
  const Cells& row = folder.completed_games.done.at(id);
  const std::size_t first = folder.format.first_outcome();
  for (std::size_t i = 0; i < outcome.size(); ++i) {
    if (outcome[i] == row[first + i]) continue;
    differences.push_back({id, folder.format.columns()[first + i], row[first + i], outcome[i]});
    return;
  }
}

}  // namespace

Verification verify(const ResultFolder& folder, int sample, int workers,
                    const std::function<Cells(const GameConfiguration&)>& outcome,
                    std::FILE* progress) {
  const std::vector<std::size_t> games = spread_evenly(good_games(folder), sample);
  if (games.empty()) {
    throw InputError({folder.path.string()}, "", "holds no finished game that could be verified");
  }
  Verification verification;
  Progress bar(progress, {.total = static_cast<int>(games.size())});
  const auto done = [&](const JobResult& result) {
    const std::string& id = folder.games[result.job].id;
    ++verification.played;
    if (result.failure.empty()) {
      compare(folder, id, csv_cells(result.payload).value(), verification.differences);
    } else {
      verification.differences.push_back({id, "status", "ok", result.failure});
    }
    bar.game_done();
  };
  const WorkerCalls calls{
      [&](std::size_t i) { return csv_line(outcome(folder.games[i].configuration)); }, done,
      [&bar] { bar.tick(); }};
  WorkerOptions options;
  options.workers = workers;
  do_jobs(games, options, calls);
  if (verification.played < static_cast<int>(games.size())) throw Interrupted();
  return verification;
}

Verification verify(const ResultFolder& folder, int sample, int workers,
                    const std::function<GameRecord(const GameConfiguration&)>& play,
                    std::FILE* progress) {
  const std::function<Cells(const GameConfiguration&)> outcome =
      [&play](const GameConfiguration& game) { return outcome_of(play(game)); };
  return verify(folder, sample, workers, outcome, progress);
}

}  // namespace autoref::runner
