// How fast whole games are, measured against the bare physics of the same size.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "runner/bench/team_cost.hpp"
#include "runner/game/game.hpp"

namespace autoref::runner {

struct BenchResult {
  double ns_per_frame = 0;  // of whole games, median of the rounds
  double bare_ns_per_frame =
      0;                   // of the bare Box2D benchmark (sim/bare_box2d_benchmark.hpp), likewise
  double ratio = 0;        // median of the rounds' ratios
  double x_real_time = 0;  // simulated seconds per wall second
  std::uint64_t signature = 0;  // of the fixed games; changes with any change of behaviour
  std::array<double, kPhaseCount> shares{};  // of a game's time, by Phase
  double referee_ns_per_frame = 0;  // with every rule in force, filters included; of one game
  std::vector<TeamCost> teams;      // every registered one, by name
};

// Plays `rounds` full games, each with the bare Box2D benchmark for as many frames right behind it,
// so that a machine that slows down slows both.
BenchResult bench(int rounds);

// The verb: prints the result to stdout, as one JSON object if wanted. Returns the exit code.
int run_bench(bool json);

}  // namespace autoref::runner
