#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/experiment/batch_arguments.hpp"
#include "app/experiment/played_experiment.hpp"
#include "app/verbs.hpp"
#include "experiments/kinds/all_kinds.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

constexpr double kLongestWait_s = 86400;

int run_verb(const RunArguments& arguments) {
  const experiments::Scenario scenario = read_experiment(arguments);
  const auto print_tables = [&scenario](const experiments::ExperimentReport& report) {
    const std::size_t width = io::text_width(stdout);
    if (!scenario.about.empty()) fmt::print("{}\n\n", io::wrapped(scenario.about, width));
    fmt::print("{}\n", io::text_of(report.results.table, width));
  };
  return play_experiment(scenario, arguments, print_tables).exit_code;
}

// "600 for kind tune, "
std::string default_waits() {
  std::string text;
  for (const experiments::Kind* kind : experiments::kinds_of_experiments()) {
    const double wait_s = kind->make()->default_wait_s();
    if (wait_s > 0) text += fmt::format("{} for kind {}, ", wait_s, kind->name);
  }
  return text;
}

void add_wait_option(CLI::App& verb, RunArguments& arguments) {
  verb.add_option("--wait", arguments.wait_s,
                  "How long a shard waits, in s, for games of other shards that its own next games "
                  "depend on. Default: " +
                      default_waits() + "otherwise 0.")
      ->type_name("S")
      ->check(CLI::Range(0.0, kLongestWait_s));
}

}  // namespace

void add_run_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("run", "Run an experiment: a sweep, a tournament, a match or a tuning.");
  auto arguments = std::make_shared<RunArguments>();
  add_experiment_argument(*verb, *arguments, "run");
  add_batch_options(*verb, *arguments);
  add_override_options(*verb, *arguments);
  add_run_options(*verb, *arguments);
  add_wait_option(*verb, *arguments);
  verb->footer(
      "Ctrl-C lets the running games finish; a second one stops them immediately. Repeat the same\n"
      "command to continue: games whose workers were killed are played again. You can continue\n"
      "with more pairs in the same folder; with fewer, the surplus rows do not count. Another\n"
      "seed needs another folder. An existing report is updated when all games are done.\n\n"
      "Shards may share a folder, or each use its own; then copy all games/*.csv into one folder\n"
      "for autoref report. An SPRT match ends with the pair of games that decides it; shards with\n"
      "separate folders play all pairs up to the maximum. A shard of a knockout, a Swiss\n"
      "tournament or a tuning needs games of the others, in the same folder. It waits for them\n"
      "as long as --wait allows, then ends (with code 75, or 0 for a knockout); the same command\n"
      "continues.\n\n"
      "A tuning searches for better parameters of a team with SPSA or CMA-ES, then tests the\n"
      "result against the start with new games and says whether it is better. It writes\n"
      "tune.csv, the path of every parameter, and result.yaml, the tuned team. The path does not\n"
      "depend on the number of workers or shards; autoref report draws it.\n\n"
      "--progress json prints one object per line on stderr, every 5 s and at the end, with event\n"
      "(progress, end, or note with a text), done, total, void, played (by this run), elapsed_s,\n"
      "games_per_min, left_s and, depending on the kind, standings, groups, sprt, comparison,\n"
      "ties or situations, with the columns of the CSV files.\n\n"
      "Examples:\n  autoref run scenarios/handicap-speed.yaml -o results/runs/speed -j 2\n"
      "  autoref run scenarios/tune-first.yaml -o results/runs/tune");
  choose(*verb, chosen, arguments, run_verb);
}

}  // namespace autoref::app
