// The game used by most tests: basic against itself with halves of `half_s`.
#pragma once

#include <cstdint>
#include <string>

#include "game/loop/game_configuration.hpp"
#include "game/settings/game_settings.hpp"

namespace autoref {

inline game::GameConfiguration short_game(double half_s, std::uint64_t seed) {
  game::GameConfiguration game;
  game.match.half_s = half_s;
  game.seed = seed;
  return game;
}

// The same game under a rule book, on its field.
inline game::GameConfiguration short_game_by(const std::string& book, double half_s,
                                             std::uint64_t seed) {
  game::GameSettings game;
  game::choose_rules(book, game);
  game.match.half_s = half_s;
  game.seed = seed;
  return game::resolved(game);
}

}  // namespace autoref
