// Measures whether one build of AutoRef plays games faster than another.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/measured_ratio.hpp"
#include "benchmarks/options.hpp"

namespace autoref::benchmarks {

// What one build did.
struct MeasuredBuild {
  std::string build;            // its version
  double x_real_time = 0;       // simulated seconds per processor second, median of the rounds
  std::uint64_t signature = 0;  // hash over the fixed games
};

struct BuildComparison {
  MeasuredBuild before;
  MeasuredBuild after;
  // Processor time per simulated second, of `after` relative to `before`, in each round; below 1,
  // `after` is faster.
  std::vector<double> ratios;
  MeasuredRatio ratio;

  bool plays_same_games() const { return before.signature == after.signature; }
};

// One game, as measured from outside its process.
struct MeasuredGame {
  double processor_s_per_sim_s = 0;
  std::uint64_t state_hash = 0;
  std::string build;
};

// Reads what `autoref play --json` printed, having used `processor_s`. Throws InputError naming
// `program` if the text is anything else, or if the game is void.
MeasuredGame measured_game(const std::string& program, const std::string& text, double processor_s);

// In each round, both programs play the same fixed game twice, each time in a process of its own,
// in the order before, after, after, before, and the reverse in the next round, so that a slowdown
// of the machine affects both. A game may take `longest_game_s` of wall-clock time; only to detect
// hangs. Throws InputError if a program cannot be run, takes too long, fails, or prints something
// else.
BuildComparison compare_builds(const std::string& before, const std::string& after,
                               const Options& options, double longest_game_s = 600);

void print_build_comparison(const std::string& before, const std::string& after,
                            const Options& options);

}  // namespace autoref::benchmarks
