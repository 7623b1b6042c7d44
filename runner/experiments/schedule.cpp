#include "runner/experiments/schedule.hpp"

#include <fmt/format.h>

#include "runner/experiments/cells.hpp"
#include "runner/settings/resolved.hpp"
#include "runner/settings/setting_error.hpp"
#include "soccer/random.hpp"

namespace autoref::runner {
namespace {

// Limits the rows held in memory and written to one results.csv.
constexpr int kMostGames = 100000;

ScheduledGame scheduled(const Sweep& sweep, const std::vector<SettingValue>& values,
                        const GameSettings& configuration, int pair, int leg) {
  ScheduledGame game{game_id(cell_name(sweep, values), pair, leg),
                     spelt(values),
                     pair,
                     leg,
                     configuration,
                     name_of(configuration.a),
                     name_of(configuration.b)};
  set_leg(game.configuration, sweep.seed, pair, leg);
  return game;
}

// Counts in floating point, since the product of many factors could overflow an integer.
double games_in(const Sweep& sweep) {
  double games = 2.0 * sweep.pairs;
  for (const Factor& factor : sweep.factors) games *= static_cast<double>(factor.values.size());
  return games;
}

}  // namespace

GameConfiguration resolved(const ScheduledGame& game) {
  GameConfiguration configuration = resolved(game.configuration);
  configuration.id = game.id;
  return configuration;
}

std::string game_id(std::string_view played, int pair, int leg) {
  return fmt::format("{}-p{:04}-{}", played, pair, leg);
}

void refuse_network(const TeamSettings& team, std::string_view path) {
  if (!team.command.empty() || team.strategy != kNetworkStrategy) return;
  throw SettingError(fmt::format("{}.strategy", path),
                     ": a team on the network plays only in autoref live");
}

void set_leg(GameSettings& game, std::uint64_t master_seed, int pair, int leg) {
  refuse_network(game.a, "teams.a");
  refuse_network(game.b, "teams.b");
  if (game.match.control == referee::Control::kGameController)
    throw SettingError("match.control", ": a game controller commands only games of autoref play");
  game.match.a_plays = leg % 2 == 1 ? Side::kWest : Side::kEast;
  game.match.first_kickoff = pair % 2 == 1 ? Side::kWest : Side::kEast;
  game.seed = seed_of(master_seed, pair, leg);
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
  std::vector<GameSettings> configurations;
  configurations.reserve(all.size());
  for (const std::vector<SettingValue>& values : all) {
    configurations.push_back(configured(sweep, values));
  }
  std::vector<ScheduledGame> games;
  for (int pair = 1; pair <= sweep.pairs; ++pair) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const int leg : {1, 2}) {
        games.push_back(scheduled(sweep, all[i], configurations[i], pair, leg));
        games.back().unit = (games.size() - 1) / 2;
      }
    }
  }
  return games;
}

}  // namespace autoref::runner
