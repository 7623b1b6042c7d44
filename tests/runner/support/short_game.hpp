// The game of most tests: basic against itself with halves of `half_s`.
#pragma once

#include <cstdint>

#include "runner/settings/configuration.hpp"

namespace autoref::runner {

inline GameConfiguration short_game(double half_s, std::uint64_t seed) {
  GameConfiguration game;
  game.match.half_s = half_s;
  game.seed = seed;
  return game;
}

}  // namespace autoref::runner
