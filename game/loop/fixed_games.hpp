// The games that `autoref bench` and the benchmarks play: always the same, so that builds that play
// differently get different hashes.
#pragma once

#include <cstdint>
#include <string>

#include "game/loop/configuration.hpp"

namespace autoref::game {

// Number of different games; their seeds count from 1.
inline constexpr int kFixedGames = 5;

inline std::uint64_t fixed_seed(int round) {
  return 1 + static_cast<std::uint64_t>(round % kFixedGames);
}

// A full game of the default configuration, of a registered team against itself; after the last
// fixed game, the first one follows.
inline GameConfiguration fixed_game(int round,
                                    const std::string& team = TeamConfiguration{}.strategy) {
  GameConfiguration game;
  game.a.strategy = game.b.strategy = team;
  game.seed = fixed_seed(round);
  return game;
}

}  // namespace autoref::game
