// Measures whether one build of AutoRef plays games faster than another.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/measured_ratio.hpp"
#include "benchmarks/options.hpp"

namespace autoref::benchmarks {

// The results of one build.
struct MeasuredBuild {
  std::string build;            // its version
  double x_real_time = 0;       // simulated seconds per processor second, median of the rounds
  std::uint64_t signature = 0;  // hash over the fixed games
};

struct BuildComparison {
  MeasuredBuild before;
  MeasuredBuild after;
  // Processor time per simulated second of `after`, relative to `before`, in each round; `after` is
  // faster if this ratio is below 1.
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

// Reads the output of `autoref play --json`, which used `processor_s`. Throws an InputError that
// names `program` if the text is not such output or the game is void.
MeasuredGame measured_game(const std::string& program, const std::string& text, double processor_s);

// In each round, both programs play the same fixed game twice, each time in a separate process. The
// order is before, after, after, before in one round and the reverse in the next, so that a
// slowdown of the machine affects both programs. `longest_game_s` limits a game's wall-clock time;
// it serves only to detect hangs. Throws InputError if a program cannot be run, takes too long,
// fails, or prints something else.
BuildComparison compare_builds(const std::string& before, const std::string& after,
                               const Options& options, double longest_game_s = 600);

void print_build_comparison(const std::string& before, const std::string& after,
                            const Options& options);

}  // namespace autoref::benchmarks
