// Measures the speed-up of several workers over one, and the cost of dispatching games.
#pragma once

namespace autoref::runner {

struct WorkersBench {
  int workers = 2;
  double games_per_min_alone = 0;     // with one worker, median of the rounds
  double games_per_min_together = 0;  // with all workers, median of the rounds
  double speedup = 0;                 // median of the rounds' ratios
  double parent_cpu_s_per_game = 0;   // by the process that dispatches games
  double workers_cpu_s_per_game = 0;  // by the processes that play games
  double parent_share() const { return parent_cpu_s_per_game / workers_cpu_s_per_game; }
};

// Runs small experiments of full games in a temporary folder. Each round runs the experiment with
// one worker and immediately afterwards with `workers` workers, so a slowdown of the machine
// affects both.
WorkersBench bench_workers(int rounds, int workers);

// Runs the verb: prints the result to stdout, with `json` as one JSON object. Returns the exit
// code.
int run_workers_bench(bool json);

}  // namespace autoref::runner
