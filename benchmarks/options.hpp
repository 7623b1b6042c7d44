// Options of several benchmarks.
#pragma once

#include <string>

#include "runner/game/configuration.hpp"

namespace autoref::benchmarks {

// The fewest rounds that give a 95 % interval of the median
// (runner/statistics/median_interval.hpp).
inline constexpr int kFewestRounds = 6;

struct Options {
  bool strong = false;  // whether the strongest team plays against itself, not the default team
  int rounds = 12;      // at least kFewestRounds

  std::string team() const { return strong ? "cobalt" : runner::TeamConfiguration{}.strategy; }
};

}  // namespace autoref::benchmarks
