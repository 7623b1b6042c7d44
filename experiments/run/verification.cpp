#include "experiments/run/verification.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <optional>
#include <stdexcept>

#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "io/processes/progress.hpp"
#include "io/processes/workers.hpp"

namespace autoref::experiments {
namespace {

// Systematic sampling: a fixed step through the list, which selects the same games every time.
std::vector<std::size_t> spread_evenly(const std::vector<std::size_t>& all, int count) {
  const std::size_t wanted = std::min(all.size(), static_cast<std::size_t>(count));
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(all[i * all.size() / wanted]);
  return chosen;
}

// Compares a replayed game with its row. Ignores the configuration's hash, which depends on the
// build.
std::optional<ColumnDifference> difference_from(const ResultFolder& folder,
                                                const io::JobResult& result) {
  if (!result.failure.empty()) return ColumnDifference{"status", "ok", result.failure};
  std::optional<GameRow> now = folder.format.read(result.payload);
  if (!now) throw std::logic_error("a worker's answer is not a row: " + result.payload);
  const GameRow& stored = folder.completed_games.done.at(now->game_id);
  now->config_hash = stored.config_hash;
  return folder.format.first_difference(stored, *now);
}

}  // namespace

Verification verify(const ResultFolder& folder, int sample, int workers,
                    const std::function<void(const game::GameConfiguration&, GameRow&)>& play,
                    std::FILE* progress) {
  const std::vector<std::size_t> games = spread_evenly(folder.good_games(), sample);
  if (games.empty()) {
    throw io::InputError({folder.path.string()}, "",
                         "holds no games that ended normally, so there is nothing to verify");
  }
  Verification verification;
  io::Progress bar(progress, {.total = static_cast<int>(games.size())});
  const auto work = [&](const io::Job& job) {
    const ScheduledGame& game = folder.games[job.number];
    GameRow row = row_of(game);
    play(resolved(game), row);
    return folder.format.line(row);
  };
  const auto done = [&](const io::JobResult& result) {
    ++verification.played;
    if (const auto difference = difference_from(folder, result))
      verification.differences.push_back({folder.games[result.job].id, *difference});
    bar.game_done();
  };
  io::WorkerOptions options;
  options.workers = workers;
  io::do_jobs(games, options, {work, done, [&bar] { bar.tick(); }});
  if (verification.played < static_cast<int>(games.size())) throw io::Interrupted();
  return verification;
}

}  // namespace autoref::experiments
