// The games that benchmarks play: always the same, so that a hash over them tells builds apart.
#pragma once

#include <cstdint>
#include <string>

#include "runner/game/configuration.hpp"

namespace autoref::runner {

// Number of different games; their seeds count from 1.
inline constexpr int kFixedGames = 5;

// Who plays: the default team against itself, or the strongest team against itself.
enum class FixedTeams : std::uint8_t { kPlain, kStrong };

inline std::string team_of(FixedTeams teams) {
  return teams == FixedTeams::kStrong ? "cobalt" : TeamConfiguration{}.strategy;
}

inline std::uint64_t fixed_seed(int round) {
  return 1 + static_cast<std::uint64_t>(round % kFixedGames);
}

// A full game of the default configuration; after the last fixed game, the first one follows.
inline GameConfiguration fixed_game(FixedTeams teams, int round) {
  GameConfiguration game;
  game.a.strategy = game.b.strategy = team_of(teams);
  game.seed = fixed_seed(round);
  return game;
}

}  // namespace autoref::runner
