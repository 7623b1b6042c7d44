#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "runner/cli/command_line.hpp"
#include "runner/experiments/reading/effective.hpp"
#include "runner/experiments/reading/scenario_reader.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/judge/judge_games.hpp"
#include "runner/judge/judge_report.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& folder, const JudgeReport& report, const Scenario& scenario) {
  replace_file(folder / "judge.csv", csv_of(report));
  replace_file(folder / "faults.csv", report.faults_csv);
  replace_file(folder / "effective.yaml", effective_text(scenario));
}

}  // namespace

int judge_verb(const JudgeArguments& arguments) {
  const Scenario scenario = read_scenario(arguments.file, assignments_in(arguments.sets));
  const auto* schedule = std::get_if<JudgeSchedule>(&scenario.content);
  if (schedule == nullptr) {
    throw InputError({arguments.file}, "kind",
                     fmt::format("this is a {}, not a judge; play it with: autoref {} {}",
                                 kind_of(scenario), verb_of(scenario), arguments.file));
  }
  const fs::path folder = arguments.results_folder();
  create_folder(folder);
  const std::vector<JudgeGame> games = games_of(*schedule);
  const int workers = arguments.worker_count();
  const JudgeReport report = report_of(*schedule, judge_games(games, workers, stderr));
  write(folder, report, scenario);
  if (arguments.json) {
    fmt::print("{}\n", json_of(report));
  } else {
    fmt::print("{}\n{}\n{}   a row per missed event and wrong call\n", markdown_of(report),
               (folder / "judge.csv").string(), (folder / "faults.csv").string());
  }
  const auto all = static_cast<double>(games.size());
  return static_cast<double>(report.void_games.size()) <= kMostVoid * all ? kDone : kTooManyVoid;
}

void add_judge_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("judge", "Hold the referee's calls against the truth.");
  auto arguments = std::make_shared<JudgeArguments>();
  add_batch_options(*verb, *arguments, "Scenario of kind judge.");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->footer(
      "A call is right where the same event truly happened by the same side's fault, at most 0.25 "
      "s\n"
      "after the call and at most 1 s before it.\n\n"
      "Example:\n  autoref judge scenarios/judge.yaml -o results/runs/judge");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return judge_verb(*arguments); }; });
}

}  // namespace autoref::runner
