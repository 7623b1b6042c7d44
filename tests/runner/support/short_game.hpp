// The game used by most tests: basic against itself with halves of `half_s`.
#pragma once

#include <cstdint>
#include <string>

#include "runner/game/configuration.hpp"
#include "runner/settings/resolved.hpp"

namespace autoref::runner {

inline GameConfiguration short_game(double half_s, std::uint64_t seed) {
  GameConfiguration game;
  game.match.half_s = half_s;
  game.seed = seed;
  return game;
}

// The same game under a rule book, on its field.
inline GameConfiguration short_game_by(const std::string& book, double half_s, std::uint64_t seed) {
  GameSettings game;
  choose_rules(book, game);
  game.match.half_s = half_s;
  game.seed = seed;
  return resolved(game);
}

}  // namespace autoref::runner
