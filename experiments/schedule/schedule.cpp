#include "experiments/schedule/schedule.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <numeric>
#include <utility>

#include "game/settings/game_settings.hpp"
#include "game/settings/setting_value.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

// Limits the rows held in memory and written to one results.csv.
constexpr int kMostGames = 100000;

// The matchups of `teams` teams, collected as indices into matchups_among().
class MatchupOrder {
 public:
  explicit MatchupOrder(std::size_t teams) : teams_(teams) {
    indices_.reserve(teams * (teams - 1) / 2);
  }

  void add(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax(a, b);
    // Each team before `low` is the first of its matchups with all teams after it.
    indices_.push_back(low * (2 * teams_ - low - 1) / 2 + high - low - 1);
  }

  std::vector<std::size_t> indices() && { return std::move(indices_); }

 private:
  std::size_t teams_;
  std::vector<std::size_t> indices_;
};

// The first team stays in place.
std::vector<std::size_t> circle_order(std::size_t teams) {
  const std::size_t moving = teams - 1;
  MatchupOrder order(teams);
  for (std::size_t round = 0; round < moving; ++round) {
    for (std::size_t i = 0; i < teams / 2; ++i) {
      // The first team's matchup does not always come first in a round, so it is not always played
      // by the same shard.
      const std::size_t k = (round + i) % (teams / 2);
      const std::size_t other = k == 0 ? 0 : 1 + (round + moving - k) % moving;
      order.add(1 + (round + k) % moving, other);
    }
  }
  return std::move(order).indices();
}

// A zigzag through the teams on a circle, with the first team at both ends.
std::vector<std::size_t> walecki_cycle(std::size_t teams, std::size_t turn) {
  const std::size_t on_circle = teams - 1;
  std::vector<std::size_t> cycle = {0, 1 + turn};
  for (std::size_t k = 1; k < on_circle / 2; ++k) {
    cycle.push_back(1 + (turn + k) % on_circle);
    cycle.push_back(1 + (turn + on_circle - k) % on_circle);
  }
  cycle.push_back(1 + (turn + on_circle / 2) % on_circle);
  return cycle;
}

std::vector<std::size_t> cycles_order(std::size_t teams) {
  MatchupOrder order(teams);
  for (std::size_t turn = 0; turn < teams / 2; ++turn) {
    const std::vector<std::size_t> cycle = walecki_cycle(teams, turn);
    for (const std::size_t start : {0, 1}) {
      for (std::size_t i = start; i < teams; i += 2) order.add(cycle[i], cycle[(i + 1) % teams]);
    }
  }
  return std::move(order).indices();
}

}  // namespace

SharedSettings::SharedSettings(game::GameSettings game)
    : leg_{game.match.a_plays, game.match.first_kickoff, game.seed} {
  game.given.clear();
  const auto base = std::make_shared<const game::GameSettings>(std::move(game));
  a_ = {base, &base->a};
  b_ = {base, &base->b};
  base_ = base;
}

SharedSettings SharedSettings::between(std::shared_ptr<const game::TeamSettings> a,
                                       std::shared_ptr<const game::TeamSettings> b) const {
  SharedSettings other = *this;
  other.a_ = std::move(a);
  other.b_ = std::move(b);
  return other;
}

SharedSettings SharedSettings::with(const LegSettings& leg) const {
  SharedSettings other = *this;
  other.leg_ = leg;
  return other;
}

SharedSettings SharedSettings::starting_from(std::shared_ptr<const game::StartState> start) const {
  SharedSettings other = *this;
  other.start_ = std::move(start);
  return other;
}

game::GameSettings SharedSettings::combined() const {
  game::GameSettings game = *base_;
  game.a = *a_;
  game.b = *b_;
  game.match.a_plays = leg_.a_plays;
  game.match.first_kickoff = leg_.first_kickoff;
  game.seed = leg_.seed;
  if (start_) game.start = leg_.a_plays == Side::kWest ? *start_ : game::mirrored(*start_);
  return game;
}

game::GameConfiguration resolved(const ScheduledGame& game) {
  game::GameConfiguration configuration = game::resolved(game.settings.combined());
  configuration.id = game.id;
  return configuration;
}

std::string game_id(std::string_view played, int pair, int leg) {
  return fmt::format("{}-p{:04}-{}", played, pair, leg);
}

void refuse_network(const game::TeamSettings& team, std::string_view path) {
  if (!team.program.command.empty() || team.strategy != game::kNetworkStrategy) return;
  throw game::SettingError(fmt::format("{}.strategy", path),
                           ": a team on the network can only play in autoref live");
}

void refuse_game_controller(const game::GameSettings& game) {
  if (game.match.control != referee::Control::kGameController) return;
  throw game::SettingError("match.control",
                           ": a game controller can only command games of autoref play");
}

LegSettings leg_of(std::uint64_t master_seed, int pair, int leg) {
  return {leg % 2 == 1 ? Side::kWest : Side::kEast, pair % 2 == 1 ? Side::kWest : Side::kEast,
          seed_of(master_seed, pair, leg)};
}

void refuse_too_many(double games, std::string_view key) {
  if (games <= kMostGames) return;
  throw game::SettingError(
      std::string(key),
      fmt::format(": these settings amount to {:.0f} games; one experiment may have at most {}",
                  games, kMostGames));
}

std::uint64_t seed_of(std::uint64_t master_seed, int pair, int leg) {
  // A chain of hashes instead of a stream of random numbers: each game's seed can be computed
  // alone, and similar numbers give unrelated seeds. The shift leaves 53 bits.
  const std::uint64_t of_pair = mix_bits(mix_bits(master_seed) + static_cast<std::uint64_t>(pair));
  return mix_bits(of_pair + static_cast<std::uint64_t>(leg)) >> 11;
}

std::vector<ScheduledGame> games_in_turns(
    const std::vector<std::size_t>& order, int pairs,
    const std::function<ScheduledGame(std::size_t variant, int pair, int leg)>& make) {
  std::vector<ScheduledGame> games;
  games.reserve(2 * static_cast<std::size_t>(pairs) * order.size());
  for (int pair = 1; pair <= pairs; ++pair) {
    for (const std::size_t variant : order) {
      for (const int leg : {1, 2}) {
        games.push_back(make(variant, pair, leg));
        games.back().unit = (games.size() - 1) / 2;
        games.back().variant = variant;
        games.back().variants = order.size();
      }
    }
  }
  return games;
}

std::vector<std::size_t> round_robin_order(std::size_t teams) {
  if (teams < 2) return {};
  return teams % 2 == 0 ? circle_order(teams) : cycles_order(teams);
}

// Combines the order so far with one list after the other. Both the order and the list are cycled
// through. The combinations would repeat after the least common multiple of their lengths, so from
// there on the list is shifted by one.
std::vector<std::size_t> combinations_order(const std::vector<std::size_t>& sizes) {
  std::vector<std::size_t> order = {0};
  for (const std::size_t size : sizes) {
    const std::size_t period = std::lcm(order.size(), size);
    std::vector<std::size_t> longer;
    longer.reserve(order.size() * size);
    for (std::size_t i = 0; i < order.size() * size; ++i) {
      longer.push_back(order[i % order.size()] * size + (i + i / period) % size);
    }
    order = std::move(longer);
  }
  return order;
}

}  // namespace autoref::experiments
