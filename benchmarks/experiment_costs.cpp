#include "benchmarks/experiment_costs.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "experiments/kinds/sweep/sweep.hpp"
#include "experiments/run/run_experiment.hpp"
#include "io/build_id.hpp"
#include "io/command.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/table.hpp"
#include "io/terminal.hpp"

namespace autoref::benchmarks {
namespace {

using Clock = std::chrono::steady_clock;

constexpr MeasuredExperiment kFullGames{.pairs = 6};
constexpr MeasuredExperiment kShortGames{.pairs = 150, .half_s = 10, .halves = 1};
constexpr MeasuredExperiment kCrowdedGames{.pairs = 48, .half_s = 20, .with_memory = true};
constexpr std::array kCrowds = {1, 4, 16, 64};

experiments::Sweep sweep_of(const MeasuredExperiment& experiment) {
  experiments::Sweep sweep;
  sweep.base.match.half_s = experiment.half_s;
  sweep.base.match.halves = experiment.halves;
  sweep.factors = {{"b.handicap", {1.0}}};
  sweep.pairs = experiment.pairs;
  return sweep;
}

double waits_of(int whose) {
  rusage usage{};
  getrusage(whose, &usage);
  return static_cast<double>(usage.ru_nvcsw);
}

// The processor time that a program needs to start, read its command line and end.
double start_s_of(const std::string& program) {
  constexpr double kLongest_s = 60;
  const std::optional<io::CommandResult> result =
      io::run_command({program, "--version"}, kLongest_s);
  if (!result || result->code != 0) throw std::logic_error(program + " cannot be started");
  return result->processor_s;
}

// One value per round.
struct Samples {
  std::vector<double> values;
  void add(double value) { values.push_back(value); }
  double middle() const { return experiments::median(values); }
};

struct CrowdSamples {
  Samples cost, waits, parent;
  double private_mb = 0;
  double resident_mb = 0;
};

class ExperimentRounds {
 public:
  void play_round(const std::string& program) {
    start_s_.add(start_s_of(program));
    MeasuredExperiment with_two = kFullGames;
    with_two.workers = 2;
    const double with_two_s = costs_of(with_two).wall_s;
    const RunCosts full = costs_of(kFullGames);
    speedup_.add(full.wall_s / with_two_s);
    full_s_.add(full.total_s_per_game());
    overhead_.add(full.overhead());
    set_up_.add(full.worker.set_up_s / full.total_s());
    parent_.add(full.parent_s / full.total_s());
    compare_short(full, costs_of(kShortGames));
    compare_crowds();
  }

  ExperimentCosts result(int rounds) const {
    ExperimentCosts costs;
    costs.rounds = rounds;
    costs.full_game_s = full_s_.middle();
    costs.overhead = measured_ratio(overhead_.values);
    costs.set_up_share = set_up_.middle();
    costs.parent_share = parent_.middle();
    costs.speedup = measured_ratio(speedup_.values);
    costs.short_game_s = short_s_.middle();
    costs.short_overhead = short_overhead_.middle();
    costs.short_speed = measured_ratio(short_speed_.values);
    costs.short_frames = measured_ratio(short_frames_.values);
    costs.short_wall = measured_ratio(short_wall_.values);
    costs.program_start_s = start_s_.middle();
    for (std::size_t i = 0; i < kCrowds.size(); ++i) costs.crowds.push_back(row(i));
    return costs;
  }

 private:
  void compare_short(const RunCosts& full, const RunCosts& brief) {
    const auto frame_s = [](const RunCosts& costs) {
      return costs.worker.frames_s / static_cast<double>(costs.worker.frames);
    };
    short_s_.add(brief.total_s_per_game());
    short_overhead_.add(brief.overhead());
    short_speed_.add(brief.frames_per_s() / full.frames_per_s());
    short_frames_.add(frame_s(full) / frame_s(brief));
    short_wall_.add(brief.frames_per_wall_s() / full.frames_per_wall_s());
  }

  // Every second round runs in the opposite order.
  void compare_crowds() {
    std::array<RunCosts, kCrowds.size()> costs;
    for (std::size_t i = 0; i < kCrowds.size(); ++i) {
      const std::size_t crowd = is_reversed_ ? kCrowds.size() - 1 - i : i;
      MeasuredExperiment experiment = kCrowdedGames;
      experiment.workers = kCrowds[crowd];
      costs[crowd] = costs_of(experiment);
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

  Samples start_s_, full_s_, overhead_, set_up_, parent_, speedup_;
  Samples short_s_, short_overhead_, short_speed_, short_frames_, short_wall_;
  std::array<CrowdSamples, kCrowds.size()> crowds_;
  bool is_reversed_ = false;
};

std::string text_of_share(const MeasuredRatio& share) {
  return fmt::format("{:.3f} % [{:.3f}, {:.3f}]", 100 * share.median, 100 * share.interval.low,
                     100 * share.interval.high);
}

io::TextTable crowd_table(const ExperimentCosts& costs) {
  io::TextTable table{
      {{"workers", "cost of a game", "waits per game", "parent", "private MB", "resident MB"}}};
  for (const CrowdRow& row : costs.crowds) {
    table.rows.push_back(
        {std::to_string(row.workers), text_of_ratio(row.cost),
         fmt::format("{:.2f}", row.waits_per_game), fmt::format("{:.2f} %", 100 * row.parent_share),
         fmt::format("{:.2f}", row.private_mb), fmt::format("{:.2f}", row.resident_mb)});
  }
  return table;
}

}  // namespace

RunCosts costs_of(const MeasuredExperiment& experiment) {
  const io::WorkingFolder folder;
  const WorkerMeter meter;
  experiments::ExperimentOptions options;
  options.folder = folder.path();
  options.build = io::build_id();
  options.workers = experiment.workers;
  options.play = [&meter, &experiment](const game::GameConfiguration& game) {
    return meter.play(game, experiment.with_memory);
  };
  const double parent_s = io::processor_s_of(RUSAGE_SELF);
  const double workers_s = io::processor_s_of(RUSAGE_CHILDREN);
  const double waits = waits_of(RUSAGE_CHILDREN);
  const Clock::time_point start = Clock::now();
  // When the experiment returns, all of its workers have ended.
  const experiments::ExperimentReport report =
      experiments::run_experiment({"", sweep_of(experiment)}, options);
  if (!report.is_complete) throw io::Interrupted();
  if (report.void_games > 0) throw std::logic_error("a game of the benchmark is void");
  return {meter.costs(), io::processor_s_of(RUSAGE_SELF) - parent_s,
          io::processor_s_of(RUSAGE_CHILDREN) - workers_s, waits_of(RUSAGE_CHILDREN) - waits,
          std::chrono::duration<double>(Clock::now() - start).count()};
}

ExperimentCosts measure_experiments(const std::string& program, int rounds) {
  ExperimentRounds all;
  for (int round = 0; round < rounds; ++round) all.play_round(program);
  return all.result(rounds);
}

void print_experiment_costs(const std::string& program, int rounds) {
  const ExperimentCosts costs = measure_experiments(program, rounds);
  fmt::print("medians of {} rounds, in brackets 95 % intervals\n\n", costs.rounds);
  fmt::print("starting the program        {:9.3f} ms of processor time\n",
             1000 * costs.program_start_s);
  fmt::print("a full game                 {:9.3f} s of processor time\n", costs.full_game_s);
  fmt::print("outside its frames          {} of that\n", text_of_share(costs.overhead));
  fmt::print("  creating games            {:9.3f} %\n", 100 * costs.set_up_share);
  fmt::print("  handing out, rows         {:9.3f} %\n", 100 * costs.parent_share);
  fmt::print("games with two workers      {} of those with one, per wall-clock second\n",
             text_of_ratio(costs.speedup));
  fmt::print("a game of 10 s              {:9.3f} ms of processor time\n",
             1000 * costs.short_game_s);
  fmt::print("outside its frames          {:9.2f} %\n", 100 * costs.short_overhead);
  fmt::print("frames of games of 10 s\n  per processor second      {} of those of full games\n",
             text_of_ratio(costs.short_speed));
  fmt::print("  outside overhead          {} of those of full games\n",
             text_of_ratio(costs.short_frames));
  fmt::print("  per wall-clock second     {} of those of full games, with one worker\n\n",
             text_of_ratio(costs.short_wall));
  fmt::print("{}", io::table_text(crowd_table(costs), io::text_width(stdout)));
}

}  // namespace autoref::benchmarks
