// How much faster several workers are than one, and what the process costs that hands games out.
#pragma once

namespace autoref::runner {

struct WorkersBench {
  int workers = 2;
  double games_per_min_alone = 0;     // of one worker, median of the rounds
  double games_per_min_together = 0;  // of all workers, likewise
  double speedup = 0;                 // median of the rounds' ratios
  double parent_cpu_s_per_game = 0;   // of the process that hands games out and keeps their rows
  double workers_cpu_s_per_game = 0;  // of those that play
  double parent_share() const { return parent_cpu_s_per_game / workers_cpu_s_per_game; }
};

// Runs small experiments of full games in a temporary folder: in each round one worker, then
// `workers` right behind it, so that a machine that slows down slows both.
WorkersBench bench_workers(int rounds, int workers);

// The verb: prints the result to stdout, as one JSON object if wanted. Returns the exit code.
int run_workers_bench(bool json);

}  // namespace autoref::runner
