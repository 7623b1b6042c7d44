#include "runner/bench/batch_bench.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "runner/batch/run_experiment.hpp"
#include "runner/experiments/kinds/sweep/sweep.hpp"
#include "runner/io/build_id.hpp"
#include "runner/io/command.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/processor_time.hpp"
#include "runner/io/working_folder.hpp"
#include "runner/statistics/median_interval.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

using Clock = std::chrono::steady_clock;

constexpr BenchBatch kFullGames{.pairs = 6};
constexpr BenchBatch kShortGames{.pairs = 150, .half_s = 10, .halves = 1};
constexpr BenchBatch kCrowdedGames{.pairs = 48, .half_s = 20, .with_memory = true};
constexpr std::array kCrowds = {1, 4, 16, 64};

Sweep sweep_of(const BenchBatch& batch) {
  Sweep sweep;
  sweep.base.match.half_s = batch.half_s;
  sweep.base.match.halves = batch.halves;
  sweep.factors = {{"b.handicap", {1.0}}};
  sweep.pairs = batch.pairs;
  return sweep;
}

double waits_of(int whose) {
  rusage usage{};
  getrusage(whose, &usage);
  return static_cast<double>(usage.ru_nvcsw);
}

// The processor time to start a program, read its command line and end.
double start_s_of(const std::string& program) {
  constexpr double kLongest_s = 60;
  const std::optional<CommandResult> result = run_command({program, "--version"}, kLongest_s);
  if (!result || result->code != 0) throw std::logic_error(program + " cannot be started");
  return result->processor_s;
}

// One value per round.
struct Samples {
  std::vector<double> values;
  void add(double value) { values.push_back(value); }
  double middle() const { return median(values); }
};

struct CrowdSamples {
  Samples cost, waits, parent;
  double private_mb = 0;
  double resident_mb = 0;
};

class BatchRounds {
 public:
  void play_round(const std::string& program) {
    start_s_.add(start_s_of(program));
    const BatchCosts full = costs_of(kFullGames);
    full_s_.add(full.total_s_per_game());
    overhead_.add(full.overhead());
    set_up_.add(full.worker.set_up_s / full.total_s());
    parent_.add(full.parent_s / full.total_s());
    compare_short(full, costs_of(kShortGames));
    compare_crowds();
  }

  BatchBench result(int rounds) const {
    BatchBench bench;
    bench.rounds = rounds;
    bench.full_game_s = full_s_.middle();
    bench.overhead = measured_ratio(overhead_.values);
    bench.set_up_share = set_up_.middle();
    bench.parent_share = parent_.middle();
    bench.short_game_s = short_s_.middle();
    bench.short_overhead = short_overhead_.middle();
    bench.short_speed = measured_ratio(short_speed_.values);
    bench.short_frames = measured_ratio(short_frames_.values);
    bench.short_wall = measured_ratio(short_wall_.values);
    bench.program_start_s = start_s_.middle();
    for (std::size_t i = 0; i < kCrowds.size(); ++i) bench.crowds.push_back(row(i));
    return bench;
  }

 private:
  void compare_short(const BatchCosts& full, const BatchCosts& brief) {
    const auto frame_s = [](const BatchCosts& costs) {
      return costs.worker.frames_s / static_cast<double>(costs.worker.frames);
    };
    short_s_.add(brief.total_s_per_game());
    short_overhead_.add(brief.overhead());
    short_speed_.add(brief.frames_per_s() / full.frames_per_s());
    short_frames_.add(frame_s(full) / frame_s(brief));
    short_wall_.add(brief.frames_per_wall_s() / full.frames_per_wall_s());
  }

  // Every other round in the opposite order.
  void compare_crowds() {
    std::array<BatchCosts, kCrowds.size()> costs;
    for (std::size_t i = 0; i < kCrowds.size(); ++i) {
      const std::size_t crowd = is_reversed_ ? kCrowds.size() - 1 - i : i;
      BenchBatch batch = kCrowdedGames;
      batch.workers = kCrowds[crowd];
      costs[crowd] = costs_of(batch);
    }
    is_reversed_ = !is_reversed_;
    for (std::size_t i = 0; i < kCrowds.size(); ++i) {
      CrowdSamples& crowd = crowds_[i];
      crowd.cost.add(costs[i].total_s_per_game() / costs[0].total_s_per_game());
      crowd.waits.add(costs[i].waits_per_game());
      crowd.parent.add(costs[i].parent_s / costs[i].total_s());
      crowd.private_mb = std::max(crowd.private_mb, costs[i].worker.most_private_mb);
      crowd.resident_mb = std::max(crowd.resident_mb, costs[i].worker.most_resident_mb);
    }
  }

  CrowdRow row(std::size_t i) const {
    const CrowdSamples& crowd = crowds_[i];
    return {kCrowds[i],           measured_ratio(crowd.cost.values),
            crowd.waits.middle(), crowd.parent.middle(),
            crowd.private_mb,     crowd.resident_mb};
  }

  Samples start_s_, full_s_, overhead_, set_up_, parent_;
  Samples short_s_, short_overhead_, short_speed_, short_frames_, short_wall_;
  std::array<CrowdSamples, kCrowds.size()> crowds_;
  bool is_reversed_ = false;
};

}  // namespace

BatchCosts costs_of(const BenchBatch& batch) {
  const WorkingFolder folder;
  const WorkerMeter meter;
  ExperimentOptions options;
  options.folder = folder.path();
  options.build = build_id();
  options.workers = batch.workers;
  options.play = [&meter, &batch](const GameConfiguration& game) {
    return meter.play(game, batch.with_memory);
  };
  const double parent_s = processor_s_of(RUSAGE_SELF);
  const double workers_s = processor_s_of(RUSAGE_CHILDREN);
  const double waits = waits_of(RUSAGE_CHILDREN);
  const Clock::time_point start = Clock::now();
  // Once the experiment returns, all workers have been waited for.
  const ExperimentReport report = run_experiment({"", sweep_of(batch)}, options);
  if (!report.is_complete) throw Interrupted();
  if (report.void_games > 0) throw std::logic_error("a game of the benchmark is void");
  return {meter.costs(), processor_s_of(RUSAGE_SELF) - parent_s,
          processor_s_of(RUSAGE_CHILDREN) - workers_s, waits_of(RUSAGE_CHILDREN) - waits,
          std::chrono::duration<double>(Clock::now() - start).count()};
}

MeasuredRatio measured_ratio(const std::vector<double>& values) {
  return {median(values), median_interval(values).value()};
}

BatchBench bench_batch(const std::string& program, int rounds) {
  BatchRounds all;
  for (int round = 0; round < rounds; ++round) all.play_round(program);
  return all.result(rounds);
}

}  // namespace autoref::runner
