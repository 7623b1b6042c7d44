// Measures whether this build plays games faster than another build of AutoRef.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runner/bench/bench_rounds.hpp"
#include "runner/bench/fixed_games.hpp"
#include "runner/statistics/interval.hpp"

namespace autoref::runner {

struct ComparisonOptions {
  FixedTeams teams = FixedTeams::kPlain;
  int rounds = kDefaultRounds;  // at least kFewestRounds
  double longest_game_s = 600;  // wall-clock limit of a game; only to detect hangs
};

// What one build did.
struct MeasuredBuild {
  std::string build;            // its version
  double x_real_time = 0;       // simulated seconds per processor second, median of the rounds
  std::uint64_t signature = 0;  // hash over the fixed games
};

struct BuildComparison {
  MeasuredBuild current;
  MeasuredBuild other;
  // Processor time per simulated second, this build's relative to the other's, in each round; below
  // 1, this build is faster.
  std::vector<double> ratios;
  double ratio = 0;   // their median
  Interval interval;  // of the median (statistics/median_interval.hpp)

  bool plays_same_games() const { return current.signature == other.signature; }
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
// in the order other, this, this, other, and the reverse in the next round, so that a slowdown of
// the machine affects both. Throws InputError if a program cannot be run, takes too long, fails, or
// prints something else.
BuildComparison compare_builds(const std::string& current, const std::string& other,
                               const ComparisonOptions& options);

std::string comparison_json(const BuildComparison& comparison);

// Runs the verb: compares this program with `other` and prints the result to stdout, with `json` as
// one JSON object. Returns the exit code.
int run_build_comparison(const std::string& other, const ComparisonOptions& options, bool json);

}  // namespace autoref::runner
