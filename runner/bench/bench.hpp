// Measures the speed of whole games relative to a bare Box2D simulation of the same size.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "runner/bench/fixed_games.hpp"
#include "runner/bench/team_cost.hpp"
#include "runner/game/game.hpp"

namespace autoref::runner {

struct BenchResult {
  double ns_per_frame = 0;  // in whole games, median of the rounds
  // Time per frame of the bare Box2D benchmark (sim/bare_box2d_benchmark.hpp), median of the
  // rounds.
  double bare_ns_per_frame = 0;
  double ratio = 0;             // median of the rounds' ratios
  double x_real_time = 0;       // simulated seconds per wall second
  std::uint64_t signature = 0;  // hash over the fixed games; changes whenever behaviour changes
  std::array<double, kPhaseCount> shares{};  // fraction of a game's time spent in each Phase
  double referee_ns_per_frame = 0;  // in one game with every rule in force, including the filters
  std::vector<TeamCost> teams;      // all registered teams, by name; empty if not measured
};

// Plays the fixed games, each immediately followed by the bare Box2D benchmark with as many frames,
// so a slowdown of the machine affects both. Leaves out the teams' costs.
BenchResult bench(FixedTeams teams);

// One JSON object, without `team_ns_per_decision` if no team was measured.
std::string bench_json(const BenchResult& result);

// Runs the verb: prints the result to stdout, with `json` as one JSON object; measures the teams'
// costs only with the plain fixed games. Returns the exit code.
int run_bench(FixedTeams teams, bool json);

}  // namespace autoref::runner
