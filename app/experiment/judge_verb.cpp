#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "app/experiment/batch_arguments.hpp"
#include "app/results/judged_results.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/kinds/judge/judge_schedule.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/run_experiment.hpp"
#include "game/settings/assignments.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "judge/judged_rows.hpp"

namespace autoref::app {
namespace {

struct JudgeArguments : BatchArguments {
  std::string seeds;  // name of the only master seed to play; empty: all seeds of the file
  bool allow_mixed_build = false;
  bool json = false;
};

namespace fs = std::filesystem;

experiments::Scenario read_judge(const JudgeArguments& arguments) {
  experiments::Scenario scenario =
      experiments::read_scenario(arguments.file, game::assignments_in(arguments.sets));
  if (auto* schedule = scenario.as<experiments::JudgeSchedule>()) {
    if (!arguments.seeds.empty())
      game::locate_errors("--seeds", [&] { experiments::keep_seed(*schedule, arguments.seeds); });
    return scenario;
  }
  throw io::InputError(
      {arguments.file}, "kind",
      fmt::format("this file is of kind {}, not a judge; play it with: autoref {} {}",
                  experiments::kind_of(scenario), experiments::verb_of(scenario), arguments.file));
}

experiments::ExperimentReport judge_all(const JudgeArguments& arguments,
                                        const experiments::Scenario& scenario) {
  experiments::ExperimentOptions options;
  options.folder = arguments.results_folder();
  options.build = io::build_id();
  options.workers = worker_count(arguments.workers);
  options.allow_mixed_build = arguments.allow_mixed_build;
  options.outcomes =
      judge::judged_outcomes(scenario.get<experiments::JudgeSchedule>(), options.folder);
  options.progress = stderr;
  return experiments::run_experiment(scenario, options);
}

int judge_verb(const JudgeArguments& arguments) {
  const experiments::Scenario scenario = read_judge(arguments);
  const experiments::ExperimentReport run = judge_all(arguments, scenario);
  if (run.is_interrupted) {
    io::write_message(
        stderr,
        fmt::format(
            "autoref: interrupted with {} of {} games done; repeat the command to continue\n",
            run.done, run.games));
    return io::kInterrupted;
  }
  const fs::path folder = arguments.results_folder();
  const judge::JudgeReport report =
      judge::report_of(experiments::open_results(folder, std::string(io::build_id())));
  write_judged(folder, report);
  if (arguments.json) {
    fmt::print("{}\n", judge::json_of(report));
  } else {
    print_judged(report);
    print_rule_notes(run);
    print_judged_files(folder);
  }
  return static_cast<double>(report.void_games.size()) <= io::kMostVoid * run.games
             ? io::kDone
             : io::kTooManyVoid;
}

}  // namespace

void add_judge_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("judge", "Compare the referee's calls with the ground truth.");
  auto arguments = std::make_shared<JudgeArguments>();
  add_experiment_argument(*verb, *arguments, "judge");
  add_batch_options(*verb, *arguments);
  verb->add_option("--seeds", arguments->seeds,
                   "Play only the games of one of the file's seeds. Default: all.")
      ->type_name("tuning|test");
  verb->add_flag("--allow-mixed-build", arguments->allow_mixed_build,
                 "Continue in a folder that holds games of another build; those do not count.");
  add_json_flag(*verb, arguments->json);
  verb->footer(
      "A call is right if the same event truly happened, with the same side at fault, at most\n"
      "0.25 s after the call and at most 1 s before it. You can stop with Ctrl-C; the same\n"
      "command continues. faults.csv lists every missed event and wrong call with an id: autoref\n"
      "results replay DIR ID replays its game. autoref report and the verbs of autoref results "
      "also\n"
      "accept the folder.\n\n"
      "Example:\n  autoref judge scenarios/judge.yaml -o results/runs/judge");
  choose(*verb, chosen, arguments, judge_verb);
}

}  // namespace autoref::app
