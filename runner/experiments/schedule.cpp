#include "runner/experiments/schedule.hpp"

#include <fmt/format.h>

#include "runner/experiments/cells.hpp"
#include "runner/experiments/playing_order.hpp"
#include "runner/settings/resolved.hpp"
#include "runner/settings/setting_error.hpp"
#include "soccer/random.hpp"

namespace autoref::runner {
namespace {

// Limits the rows held in memory and written to one results.csv.
constexpr int kMostGames = 100000;

ScheduledGame scheduled(const Sweep& sweep, const std::vector<SettingValue>& values,
                        const SharedSettings& settings, int pair, int leg) {
  return {game_id(cell_name(sweep, values), pair, leg),
          spelt(values),
          pair,
          leg,
          settings.with(leg_of(sweep.seed, pair, leg)),
          name_of(settings.a()),
          name_of(settings.b())};
}

SharedSettings settings_of_cell(const Sweep& sweep, const std::vector<SettingValue>& values) {
  GameSettings game = configured(sweep, values);
  refuse_network(game.a, "teams.a");
  refuse_network(game.b, "teams.b");
  refuse_game_controller(game);
  return SharedSettings(std::move(game));
}

std::vector<std::size_t> playing_order(const Sweep& sweep) {
  std::vector<std::size_t> sizes;
  sizes.reserve(sweep.factors.size());
  for (const Factor& factor : sweep.factors) sizes.push_back(factor.values.size());
  return combinations_order(sizes);
}

// Counts in floating point, since the product of many factors could overflow an integer.
double games_in(const Sweep& sweep) {
  double games = 2.0 * sweep.pairs;
  for (const Factor& factor : sweep.factors) games *= static_cast<double>(factor.values.size());
  return games;
}

}  // namespace

GameConfiguration resolved(const ScheduledGame& game) {
  GameConfiguration configuration = resolved(game.settings.whole());
  configuration.id = game.id;
  return configuration;
}

std::string game_id(std::string_view played, int pair, int leg) {
  return fmt::format("{}-p{:04}-{}", played, pair, leg);
}

void refuse_network(const TeamSettings& team, std::string_view path) {
  if (!team.program.command.empty() || team.strategy != kNetworkStrategy) return;
  throw SettingError(fmt::format("{}.strategy", path),
                     ": a team on the network plays only in autoref live");
}

void refuse_game_controller(const GameSettings& game) {
  if (game.match.control != referee::Control::kGameController) return;
  throw SettingError("match.control", ": a game controller commands only games of autoref play");
}

LegSettings leg_of(std::uint64_t master_seed, int pair, int leg) {
  return {leg % 2 == 1 ? Side::kWest : Side::kEast, pair % 2 == 1 ? Side::kWest : Side::kEast,
          seed_of(master_seed, pair, leg)};
}

void refuse_too_many(double games, std::string_view key) {
  if (games <= kMostGames) return;
  throw SettingError(
      std::string(key),
      fmt::format(": these settings make {:.0f} games; one experiment may have at most {}", games,
                  kMostGames));
}

std::uint64_t seed_of(std::uint64_t master_seed, int pair, int leg) {
  // A chain of hashes instead of a stream of random numbers: each game's seed can be computed
  // alone, and similar numbers give unrelated seeds. The shift leaves 53 bits.
  const std::uint64_t of_pair = mix_bits(mix_bits(master_seed) + static_cast<std::uint64_t>(pair));
  return mix_bits(of_pair + static_cast<std::uint64_t>(leg)) >> 11;
}

std::vector<std::vector<SettingValue>> combinations(const std::vector<Factor>& factors) {
  std::vector<std::vector<SettingValue>> all = {{}};
  for (const Factor& factor : factors) {
    // Cartesian product, built up one factor at a time.
    std::vector<std::vector<SettingValue>> longer;
    for (const std::vector<SettingValue>& start : all) {
      for (const SettingValue& value : factor.values) {
        longer.push_back(start);
        longer.back().push_back(value);
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<ScheduledGame> scheduled_games(const Sweep& sweep) {
  refuse_too_many(games_in(sweep));
  const std::vector<std::vector<SettingValue>> all = combinations(sweep.factors);
  std::vector<SharedSettings> settings;
  settings.reserve(all.size());
  for (const std::vector<SettingValue>& values : all) {
    settings.push_back(settings_of_cell(sweep, values));
  }
  const std::vector<std::size_t> order = playing_order(sweep);
  std::vector<ScheduledGame> games;
  for (int pair = 1; pair <= sweep.pairs; ++pair) {
    for (const std::size_t i : order) {
      for (const int leg : {1, 2}) {
        games.push_back(scheduled(sweep, all[i], settings[i], pair, leg));
        games.back().unit = (games.size() - 1) / 2;
        games.back().variant = i;
        games.back().variants = all.size();
      }
    }
  }
  return games;
}

}  // namespace autoref::runner
