#include "runner/bench/workers_bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/batch/run_experiment.hpp"
#include "runner/experiments/kinds/sweep/sweep.hpp"
#include "runner/io/build_id.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/json.hpp"
#include "runner/io/processor_time.hpp"
#include "runner/io/working_folder.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWorkersRounds = 3;
constexpr int kWorkers = 2;
constexpr int kWorkersPairs = 6;  // 12 games per run

struct Costs {
  double wall_s = 0;
  double parent_cpu_s = 0;
  double workers_cpu_s = 0;
};

// Plays all games of the experiment, from reading the folder to writing the results.
Costs run_with(int workers) {
  const WorkingFolder folder;
  Sweep sweep;
  sweep.factors = {{"b.handicap", {1.0}}};
  sweep.pairs = kWorkersPairs;
  sweep.seed = 1;
  ExperimentOptions options;
  options.folder = folder.path();
  options.build = build_id();
  options.workers = workers;
  options.play = [](const GameConfiguration& game) { return play(game); };
  // Once the experiment returns, all workers have been waited for.
  const Costs before{0, processor_s_of(RUSAGE_SELF), processor_s_of(RUSAGE_CHILDREN)};
  const Clock::time_point start = Clock::now();
  if (!run_experiment({"", sweep}, options).is_complete) throw Interrupted();
  return {std::chrono::duration<double>(Clock::now() - start).count(),
          processor_s_of(RUSAGE_SELF) - before.parent_cpu_s,
          processor_s_of(RUSAGE_CHILDREN) - before.workers_cpu_s};
}

double games_per_min(const Costs& costs) { return 60 * 2 * kWorkersPairs / costs.wall_s; }

std::string json_of(const WorkersBench& result) {
  return json_text({{"workers", result.workers},
                    {"games_per_min_alone", rounded(result.games_per_min_alone, 1)},
                    {"games_per_min_together", rounded(result.games_per_min_together, 1)},
                    {"speedup", rounded(result.speedup, 3)},
                    {"parent_cpu_s_per_game", rounded(result.parent_cpu_s_per_game, 5)},
                    {"workers_cpu_s_per_game", rounded(result.workers_cpu_s_per_game, 5)},
                    {"parent_share", rounded(result.parent_share(), 5)}});
}

}  // namespace

WorkersBench bench_workers(int rounds, int workers) {
  std::vector<double> alone, together, speedups, parent, playing;
  for (int i = 0; i < rounds; ++i) {
    const Costs one = run_with(1);
    const Costs all = run_with(workers);
    alone.push_back(games_per_min(one));
    together.push_back(games_per_min(all));
    speedups.push_back(together.back() / alone.back());
    parent.push_back(all.parent_cpu_s / (2 * kWorkersPairs));
    playing.push_back(all.workers_cpu_s / (2 * kWorkersPairs));
  }
  return {workers,          median(alone),  median(together),
          median(speedups), median(parent), median(playing)};
}

int run_workers_bench(bool json) {
  const WorkersBench result = bench_workers(kWorkersRounds, kWorkers);
  if (json) {
    fmt::print("{}\n", json_of(result));
    return kDone;
  }
  fmt::print("one worker            {:9.1f} games per minute\n", result.games_per_min_alone);
  fmt::print("{} workers             {:9.1f} games per minute\n", result.workers,
             result.games_per_min_together);
  fmt::print("ratio                 {:9.3f}   (median of {} rounds)\n", result.speedup,
             kWorkersRounds);
  fmt::print("workers               {:9.3f} s of processor time per game\n",
             result.workers_cpu_s_per_game);
  fmt::print("dispatching           {:9.3f} ms per game, {:.2f} % of that\n",
             1000 * result.parent_cpu_s_per_game, 100 * result.parent_share());
  return kDone;
}

}  // namespace autoref::runner
