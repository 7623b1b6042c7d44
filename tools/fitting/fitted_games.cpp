#include "tools/fitting/fitted_games.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string_view>

#include "game/loop/game.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "io/processes/workers.hpp"
#include "strategies/registry.hpp"

namespace autoref::tools {
namespace {

// Teams that play neither in the games for the fit nor against cobalt: its predecessor, which plays
// similarly, and a team that never shoots.
constexpr std::array<std::string_view, 2> kNotUsed = {"cobalt1", "dummy"};
constexpr std::uint64_t kFitSeed = 2026'0000'0000;
constexpr std::uint64_t kTestSeed = 2027'0000'0000;

struct TeamPair {
  std::string a;
  std::string b;
};

// All ordered pairs of teams, including each team against itself: with cobalt, or without it.
std::vector<TeamPair> pairs_of(bool has_left_out) {
  std::vector<std::string> teams;
  for (const strategies::Entry& entry : strategies::all_strategies()) {
    if (std::find(kNotUsed.begin(), kNotUsed.end(), entry.name) == kNotUsed.end())
      teams.emplace_back(entry.name);
  }
  std::vector<TeamPair> pairs;
  for (const std::string& a : teams) {
    for (const std::string& b : teams) {
      if ((a == kLeftOut || b == kLeftOut) == has_left_out) pairs.push_back({a, b});
    }
  }
  return pairs;
}

}  // namespace

std::string teams_left_out() { return fmt::format("{}, {}", kLeftOut, fmt::join(kNotUsed, ", ")); }

std::vector<std::string> texts_of_batch(const std::string& rules, Purpose purpose,
                                        std::size_t batch, const MakeGameText& make) {
  const bool is_test = purpose == Purpose::kTest;
  const std::vector<TeamPair> pairs = pairs_of(is_test);
  io::WorkerOptions pool;
  pool.workers = io::processors();
  const std::size_t first = batch * kBatch;
  std::vector<std::string> texts(kBatch);
  std::vector<std::size_t> jobs;
  jobs.reserve(kBatch);
  for (std::size_t i = 0; i < kBatch; ++i) jobs.push_back(first + i);
  const auto work = [&](const io::Job& job) {
    game::GameSettings settings;
    game::set_by_path(settings, "match.rules", rules);
    settings.a.strategy = pairs[job.number % pairs.size()].a;
    settings.b.strategy = pairs[job.number % pairs.size()].b;
    settings.seed = (is_test ? kTestSeed : kFitSeed) + job.number;
    const game::GameConfiguration game = game::resolved(settings);
    const std::unique_ptr<GameText> text = make(game);
    const game::GameRecord record = game::play(game, text.get());
    return text->text(record);
  };
  const auto done = [&](const io::JobResult& result) {
    if (!result.failure.empty()) throw std::runtime_error(result.failure);
    texts[result.job - first] = result.payload;
  };
  if (io::do_jobs(jobs, pool, {work, done, [] {}}) == io::Ending::kInterrupted)
    throw io::Interrupted();
  return texts;
}

}  // namespace autoref::tools
