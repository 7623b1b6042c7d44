#include "runner/bench/bench.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "runner/bench/answering_program.hpp"
#include "runner/bench/batch_bench.hpp"
#include "runner/bench/build_comparison.hpp"
#include "runner/bench/live_bench.hpp"
#include "runner/bench/programs_bench.hpp"
#include "runner/bench/scale_bench.hpp"
#include "runner/bench/workers_bench.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/io/errors.hpp"

namespace autoref::runner {

namespace {

struct BenchArguments {
  bool json = false;
  bool workers = false;
  bool batch = false;
  bool programs = false;
  bool answer = false;
  bool live = false;
  bool strong = false;
  bool scale = false;
  std::string other_build;
  int rounds = kDefaultRounds;
  LiveBenchOptions live_options;

  FixedTeams teams() const { return strong ? FixedTeams::kStrong : FixedTeams::kPlain; }
};

// Options of the benchmarks that play the fixed games.
std::vector<CLI::Option*> add_fixed_options(CLI::App* verb, BenchArguments& arguments) {
  verb->add_flag("--json", arguments.json, "Print one JSON object.");
  CLI::Option* strong =
      verb->add_flag("--strong", arguments.strong,
                     "Play games between the strongest teams; also with --compare and --scale.");
  CLI::Option* compare =
      verb->add_option("--compare", arguments.other_build,
                       "Instead, compare this program with another build of AutoRef.")
          ->type_name("PROGRAM");
  CLI::Option* scale = verb->add_flag(
      "--scale", arguments.scale,
      "Instead, measure how the cost of a frame grows with robots, cameras and camera presets.");
  CLI::Option* rounds =
      verb->add_option(
              "--rounds", arguments.rounds,
              fmt::format("With --compare, --scale and --batch: number of rounds, {} by default.",
                          kDefaultRounds))
          ->type_name("N")
          ->check(CLI::Range(kFewestRounds, 10000));
  compare->excludes(scale);
  CLI::Option* batch = verb->add_flag(
      "--batch", arguments.batch,
      "Instead, measure what experiments cost besides frames: start, rows, short games, workers.");
  for (CLI::Option* other : {strong, compare, scale}) batch->excludes(other);
  return {strong, compare, scale, batch, rounds};
}

// Options of the others, of which each excludes `fixed`.
void add_other_options(CLI::App* verb, BenchArguments& arguments,
                       const std::vector<CLI::Option*>& fixed) {
  CLI::Option* workers = verb->add_flag(
      "--workers", arguments.workers,
      "Instead, compare two workers with one and measure the cost of dispatching games.");
  CLI::Option* programs = verb->add_flag(
      "--programs", arguments.programs, "Instead, compare games between programs with bare pipes.");
  CLI::Option* answer = verb->add_flag(
      "--answer", arguments.answer, "Instead, be a team's program that does nothing but answer.");
  CLI::Option* live = verb->add_flag(
      "--live", arguments.live,
      "Instead, compare the late frames of live games with those of a loop that only sleeps.");
  verb->add_option("--seconds", arguments.live_options.seconds,
                   "With --live: duration of each of the two games, 60 by default.")
      ->type_name("S")
      ->check(CLI::Range(1.0, 86400.0))
      ->needs(live);
  verb->add_option("--load", arguments.live_options.load,
                   "With --live: processes that compute all the time, none by default.")
      ->type_name("N")
      ->check(CLI::Range(0, 64))
      ->needs(live);
  for (CLI::Option* other : {workers, programs, answer, live}) {
    for (CLI::Option* option : fixed) other->excludes(option);
  }
}

int run_chosen_bench(const BenchArguments& arguments, bool has_rounds) {
  if (has_rounds && arguments.other_build.empty() && !arguments.scale && !arguments.batch)
    throw InputError({"--rounds"}, "", "expected with --compare, --scale or --batch");
  if (!arguments.other_build.empty()) {
    return run_build_comparison(arguments.other_build,
                                {.teams = arguments.teams(), .rounds = arguments.rounds},
                                arguments.json);
  }
  if (arguments.scale) {
    return run_scale_bench({.teams = arguments.teams(), .rounds = arguments.rounds},
                           arguments.json);
  }
  if (arguments.batch) return run_batch_bench(arguments.rounds, arguments.json);
  if (arguments.answer) return answer_frames();
  if (arguments.live) return run_live_bench(arguments.live_options, arguments.json);
  if (arguments.programs) return run_programs_bench(arguments.json);
  return arguments.workers ? run_workers_bench(arguments.json)
                           : run_bench(arguments.teams(), arguments.json);
}

}  // namespace

void add_bench_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("bench", "Measure how fast whole games run.");
  auto arguments = std::make_shared<BenchArguments>();
  const std::vector<CLI::Option*> fixed = add_fixed_options(verb, *arguments);
  add_other_options(verb, *arguments, fixed);
  verb->footer("Example:\n  autoref bench --json");
  const CLI::Option* rounds = fixed.back();
  verb->callback([arguments, rounds, &chosen] {
    const bool has_rounds = rounds->count() > 0;
    chosen = [arguments, has_rounds] { return run_chosen_bench(*arguments, has_rounds); };
  });
}

}  // namespace autoref::runner
