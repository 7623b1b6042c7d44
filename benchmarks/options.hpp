// Options shared by several benchmarks.
#pragma once

#include <string>

#include "game/loop/game_configuration.hpp"

namespace autoref::benchmarks {

// The smallest number of rounds that allows a 95 % interval of the median
// (experiments/statistics/interval.hpp).
inline constexpr int kFewestRounds = 6;

struct Options {
  bool strong = false;  // whether the strongest team plays against itself instead of the default
                        // team
  int rounds = 12;      // at least kFewestRounds

  std::string team() const { return strong ? "cobalt" : game::TeamConfiguration{}.strategy; }
};

}  // namespace autoref::benchmarks
