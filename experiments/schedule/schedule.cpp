#include "experiments/schedule/schedule.hpp"

#include <fmt/format.h>

#include "game/settings/resolved.hpp"
#include "game/settings/setting_error.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

// Limits the rows held in memory and written to one results.csv.
constexpr int kMostGames = 100000;

}  // namespace

game::GameConfiguration resolved(const ScheduledGame& game) {
  game::GameConfiguration configuration = game::resolved(game.settings.whole());
  configuration.id = game.id;
  return configuration;
}

std::string game_id(std::string_view played, int pair, int leg) {
  return fmt::format("{}-p{:04}-{}", played, pair, leg);
}

void refuse_network(const game::TeamSettings& team, std::string_view path) {
  if (!team.program.command.empty() || team.strategy != game::kNetworkStrategy) return;
  throw game::SettingError(fmt::format("{}.strategy", path),
                           ": a team on the network plays only in autoref live");
}

void refuse_game_controller(const game::GameSettings& game) {
  if (game.match.control != referee::Control::kGameController) return;
  throw game::SettingError("match.control",
                           ": a game controller commands only games of autoref play");
}

LegSettings leg_of(std::uint64_t master_seed, int pair, int leg) {
  return {leg % 2 == 1 ? Side::kWest : Side::kEast, pair % 2 == 1 ? Side::kWest : Side::kEast,
          seed_of(master_seed, pair, leg)};
}

void refuse_too_many(double games, std::string_view key) {
  if (games <= kMostGames) return;
  throw game::SettingError(
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

}  // namespace autoref::experiments
