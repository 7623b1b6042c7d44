#include "runner/bench/bench.hpp"
#include "runner/bench/answering_program.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/bench/live_bench.hpp"
#include "runner/bench/programs_bench.hpp"
#include "runner/bench/workers_bench.hpp"
#include "runner/cli/command_line.hpp"

namespace autoref::runner {

void add_bench_verb(CLI::App& app, Chosen& chosen) {
  struct Arguments {
    bool json = false;
    bool workers = false;
    bool programs = false;
    bool answer = false;
    bool live = false;
    LiveBenchOptions live_options;
  };
  CLI::App* verb = app.add_subcommand("bench", "Measure how fast whole games run.");
  auto arguments = std::make_shared<Arguments>();
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->add_flag(
      "--workers", arguments->workers,
      "Instead, compare two workers with one and measure the cost of dispatching games.");
  verb->add_flag("--programs", arguments->programs,
                 "Instead, compare games between programs with bare pipes.");
  verb->add_flag("--answer", arguments->answer,
                 "Instead, be a team's program that does nothing but answer.");
  CLI::Option* live = verb->add_flag(
      "--live", arguments->live,
      "Instead, compare the late frames of live games with those of a loop that only sleeps.");
  verb->add_option("--seconds", arguments->live_options.seconds,
                   "With --live: duration of each of the two games, 60 by default.")
      ->type_name("S")
      ->check(CLI::Range(1.0, 86400.0))
      ->needs(live);
  verb->add_option("--load", arguments->live_options.load,
                   "With --live: processes that compute all the time, none by default.")
      ->type_name("N")
      ->check(CLI::Range(0, 64))
      ->needs(live);
  verb->footer("Example:\n  autoref bench --json");
  verb->callback([arguments, &chosen] {
    chosen = [arguments] {
      if (arguments->answer) return answer_frames();
      if (arguments->live) return run_live_bench(arguments->live_options, arguments->json);
      if (arguments->programs) return run_programs_bench(arguments->json);
      return arguments->workers ? run_workers_bench(arguments->json) : run_bench(arguments->json);
    };
  });
}

}  // namespace autoref::runner
