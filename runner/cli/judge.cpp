#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "runner/batch/run_experiment.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/cli/judged_results.hpp"
#include "runner/experiments/kinds/judge/judge_schedule.hpp"
#include "runner/experiments/kinds/scenario.hpp"
#include "runner/experiments/kinds/scenario_reader.hpp"
#include "runner/io/build_id.hpp"
#include "runner/io/errors.hpp"
#include "runner/judge/judged_rows.hpp"
#include "runner/settings/assignments.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

Scenario read_judge(const JudgeArguments& arguments) {
  Scenario scenario = read_scenario(arguments.file, assignments_in(arguments.sets));
  if (auto* schedule = scenario.as<JudgeSchedule>()) {
    if (!arguments.seeds.empty()) blame("--seeds", [&] { keep_seed(*schedule, arguments.seeds); });
    return scenario;
  }
  throw InputError({arguments.file}, "kind",
                   fmt::format("this is of kind {}, not a judge; play it with: autoref {} {}",
                               kind_of(scenario), verb_of(scenario), arguments.file));
}

ExperimentReport judge_all(const JudgeArguments& arguments, const Scenario& scenario) {
  ExperimentOptions options;
  options.folder = arguments.results_folder();
  options.build = build_id();
  options.workers = arguments.worker_count();
  options.allow_mixed_build = arguments.allow_mixed_build;
  options.outcomes = judged_outcomes(scenario.get<JudgeSchedule>(), options.folder);
  options.progress = stderr;
  return run_experiment(scenario, options);
}

}  // namespace

int judge_verb(const JudgeArguments& arguments) {
  const Scenario scenario = read_judge(arguments);
  const ExperimentReport run = judge_all(arguments, scenario);
  if (run.is_interrupted) {
    write_message(
        stderr,
        fmt::format(
            "autoref: interrupted with {} of {} games done; repeat the command to continue\n",
            run.done, run.games));
    return kInterrupted;
  }
  const fs::path folder = arguments.results_folder();
  const JudgeReport report = report_of(open_results(folder, std::string(build_id())));
  write_judged(folder, report);
  if (arguments.json) {
    fmt::print("{}\n", json_of(report));
  } else {
    print_judged(report);
    print_judged_files(folder);
  }
  return static_cast<double>(report.void_games.size()) <= kMostVoid * run.games ? kDone
                                                                                : kTooManyVoid;
}

void add_judge_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("judge", "Compare the referee's calls with the ground truth.");
  auto arguments = std::make_shared<JudgeArguments>();
  arguments->verbs = {"judge"};
  add_batch_options(*verb, *arguments);
  verb->add_option("--seeds", arguments->seeds,
                   "Play only the games of one of the file's seeds. Default: all.")
      ->type_name("tuning|test");
  verb->add_flag("--allow-mixed-build", arguments->allow_mixed_build,
                 "Continue in a folder that holds games of another build; those do not count.");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer(
      "A call is right if the same event truly happened, with the same side at fault, at most\n"
      "0.25 s after the call and at most 1 s before it. You can stop with Ctrl-C; the same\n"
      "command continues. faults.csv lists every missed event and wrong call with an id: autoref\n"
      "replay DIR ID replays its game. The verbs status, report and verify also accept the\n"
      "folder.\n\n"
      "Example:\n  autoref judge scenarios/judge.yaml -o results/runs/judge");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return judge_verb(*arguments); }; });
}

}  // namespace autoref::runner
