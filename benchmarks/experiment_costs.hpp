// Measures the cost of experiments besides the frames of their games (starting the program, games
// and workers, writing rows, running many short games or many workers), and the gain from a second
// worker.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/measured_ratio.hpp"
#include "benchmarks/options.hpp"
#include "benchmarks/worker_costs.hpp"

namespace autoref::benchmarks {

// An experiment in which the default team plays against itself.
struct MeasuredExperiment {
  int pairs = 1;  // number of pairs of games
  double half_s = 600;
  int halves = 2;
  int workers = 1;
  bool with_memory = false;  // also measure the memory of the workers
};

// The cost of one run of such an experiment, from an empty folder to the result files.
struct RunCosts {
  WorkerCosts worker;
  double parent_s = 0;   // processor time of the process that hands out games and writes rows
  double workers_s = 0;  // processor time of all workers
  double waits = 0;      // number of times a worker had to wait: for a game, a lock or a file
  double wall_s = 0;

  double total_s() const { return parent_s + workers_s; }
  // Share of the processor time spent outside frames.
  double overhead() const { return (total_s() - worker.frames_s) / total_s(); }
  double frames_per_s() const { return static_cast<double>(worker.frames) / total_s(); }
  double frames_per_wall_s() const { return static_cast<double>(worker.frames) / wall_s; }
  double total_s_per_game() const { return total_s() / static_cast<double>(worker.games); }
  double waits_per_game() const { return waits / static_cast<double>(worker.games); }
};

// Runs the experiment in a temporary folder and returns its costs. Throws Interrupted after a
// signal, and std::logic_error if a game is void.
RunCosts costs_of(const MeasuredExperiment& experiment);

// An experiment with many workers, relative to the same games with one worker in the same round.
struct CrowdRow {
  int workers = 1;
  MeasuredRatio cost;         // ratio of the processor time per game
  double waits_per_game = 0;  // median over the rounds
  double parent_share = 0;    // the parent's share of the processor time
  double private_mb = 0;      // the maximum over workers and rounds
  double resident_mb = 0;
};

struct ExperimentCosts {
  int rounds = 0;
  double full_game_s = 0;      // processor time of a full game; a median, like all members below
  MeasuredRatio overhead;      // share of a full game's processor time outside its frames
  double set_up_share = 0;     // part of that share: creating and destroying games
  double parent_share = 0;     // part of that share: handing out games, writing rows
  MeasuredRatio speedup;       // full games per wall-clock time, with two workers relative to one
  double short_game_s = 0;     // processor time of a game of 10 s
  double short_overhead = 0;   // the overhead share in games of 10 s
  MeasuredRatio short_speed;   // frames per processor time, relative to full games
  MeasuredRatio short_frames;  // the same as `short_speed`, counting only the time of the frames
  MeasuredRatio short_wall;    // frames per wall-clock time, relative to full games
  double program_start_s = 0;  // processor time of `autoref` when it has nothing to do
  std::vector<CrowdRow> crowds;
};

// In each round, runs full games with two workers and with one, games of 10 s, and games with 1, 4,
// 16 and 64 workers in turn, so that a slowdown of the machine affects all of them. Also starts
// `program`, which is `autoref`, once per round. `rounds` is at least kFewestRounds.
ExperimentCosts measure_experiments(const std::string& program, int rounds);

void print_experiment_costs(const std::string& program, int rounds);

}  // namespace autoref::benchmarks
