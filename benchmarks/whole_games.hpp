// Measures the speed of whole games relative to a bare Box2D simulation of the same size, and how
// long teams take to decide.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "benchmarks/options.hpp"
#include "game/loop/observer.hpp"

namespace autoref::benchmarks {

struct WholeGames {
  double ns_per_frame = 0;  // time per frame of whole games, median of the rounds
  // Time per frame of the bare Box2D benchmark (bare_box2d_benchmark.hpp), median of the rounds.
  double bare_ns_per_frame = 0;
  double ratio = 0;             // median of the rounds' ratios
  double x_real_time = 0;       // simulated seconds per wall second
  std::uint64_t signature = 0;  // hash over the fixed games; changes whenever behaviour changes
  std::array<double, game::kPhaseCount> shares{};  // fraction of a game's time in each Phase
  double referee_ns_per_frame = 0;  // the referee's time per frame, including the filters, in one
                                    // game with every rule in force
};

// Plays the fixed games of a registered team against itself, each immediately followed by the bare
// Box2D benchmark with the same number of frames, so that a slowdown of the machine affects both.
WholeGames measure_whole_games(const std::string& team);

// Decision time of one team.
struct TeamCost {
  std::string name;
  // Time per decision of the whole team; mean over a game against itself.
  double ns_per_decision = 0;
  std::int64_t decisions = 0;  // made by both teams in that game
};

// Measures a registered team in a fixed game against itself: six against six, two halves of 300 s.
// The result includes about 30 ns for reading the clock. Throws std::invalid_argument for an
// unknown name, and std::logic_error if the game is void.
TeamCost cost_of_team(std::string_view name);

// Prints the cost of the fixed games and, without --strong, the decision time of each registered
// team.
void print_whole_games(const Options& options);

}  // namespace autoref::benchmarks
