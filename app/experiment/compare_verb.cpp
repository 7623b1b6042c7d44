#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/experiment/ci_files.hpp"
#include "app/experiment/ci_report.hpp"
#include "app/experiment/comparison_arguments.hpp"
#include "app/experiment/played_experiment.hpp"
#include "app/experiment/requirement.hpp"
#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

struct CompareOptions : CompareArguments {
  std::string required = kDefaultRequirement;
  std::string ci_folder;  // for continuous integration; empty: no files for it
  bool is_scenario_asked = false;
};

// The answer, which teams these are, then the table and its notes.
void print_comparison(const experiments::Scenario& scenario,
                      const experiments::ExperimentReport& report, bool as_json) {
  if (as_json) {
    io::Json json = *report.results.json;
    json["about"] = scenario.about;
    fmt::print("{}\n", io::json_text(json));
    return;
  }
  const std::size_t width = io::text_width(stdout);
  const io::TextBlocks& table = report.results.table;
  fmt::print("{}", io::text_of({table.front()}, width));
  fmt::print("{}\n\n", io::wrapped(scenario.about, width));
  fmt::print("{}\n", io::text_of({table.begin() + 1, table.end()}, width));
}

// The command without what only concerns one machine: folders, workers and progress.
std::string repeating_command(const CompareOptions& options) {
  std::string command = command_text(options);
  if (options.required != kDefaultRequirement) command += " --require " + options.required;
  return command;
}

CiReport ci_report(const CompareOptions& options, const experiments::Scenario& scenario,
                   const PlayedExperiment& played) {
  const auto& comparison = scenario.get<experiments::Comparison>();
  const fs::path folder = options.results_folder();
  const experiments::ResultFolder results =
      experiments::open_results(folder, std::string(io::build_id()));
  CiReport report;
  report.name = fmt::format("autoref compare {} {}", options.old_team,
                            options.new_team.empty() ? options.old_team : options.new_team);
  report.about = scenario.about;
  report.answer = *played.report.results.comparison;
  report.requirement = requirement_of(options.required);
  report.has_too_many_void = played.exit_code == io::kTooManyVoid;
  report.games = played.report.games;
  report.problems = void_problems(results.completed_games.done);
  report.rules = comparison.base.match.rules.name;
  report.seed = std::to_string(comparison.seed);
  report.build = io::build_id();
  report.command = repeating_command(options);
  report.folder = folder.string();
  return report;
}

// Only a complete comparison has an answer: not an interrupted one, nor a shard that does not play
// the last game.
void write_ci_files(const CompareOptions& options, const experiments::Scenario& scenario,
                    const PlayedExperiment& played) {
  if (options.ci_folder.empty() || !played.report.results.comparison) return;
  write_ci_files(ci_report(options, scenario, played), options.ci_folder);
  if (options.quiet || options.json) return;
  const fs::path folder = options.ci_folder;
  fmt::print("{}   for a comment or a summary\n{}   for test reports\n",
             (folder / kCiMarkdown).string(), (folder / kCiJunit).string());
}

int compare_verb(const CompareOptions& options) {
  if (options.is_scenario_asked) {
    comparison_in(options);  // refuses what cannot be played
    fmt::print("{}", scenario_text(options));
    return io::kDone;
  }
  const experiments::Scenario scenario = comparison_in(options);
  if (!options.ci_folder.empty()) prepare_ci_folder(options.ci_folder);
  CompareOptions arguments = options;
  arguments.file = results_name(options, scenario);  // names the results folder and the page
  const PlayedExperiment played =
      play_experiment(scenario, arguments, [&](const experiments::ExperimentReport& report) {
        print_comparison(scenario, report, options.json);
      });
  write_ci_files(arguments, scenario, played);
  const auto& answer = played.report.results.comparison;
  if (played.exit_code != io::kDone || !answer) return played.exit_code;
  return requirement_of(options.required).is_met(answer->verdict) ? io::kDone : io::kNotMet;
}

void add_team_arguments(CLI::App& verb, CompareOptions& options) {
  verb.add_option("OLD", options.old_team,
                  "The team to compare with: a name that `autoref show teams` lists, a .yaml file "
                  "with a team's settings, a program, or a command in quotes.")
      ->required();
  verb.add_option("NEW", options.new_team,
                  "The team that may be better. Default: the first one, with the changes of --set "
                  "new.KEY=VALUE.");
  verb.add_option(
          "--against", options.against,
          "Opponents that both teams play as well, separated by commas. May be repeated; put "
          "a command with commas in quotes of its own.")
      ->type_name("TEAMS")
      ->allow_extra_args(false);
}

void add_game_options(CLI::App& verb, CompareOptions& options) {
  verb.add_option("--least", options.least,
                  fmt::format("The smallest difference that matters, in goals per game. Default: "
                              "{}.",
                              options.least))
      ->type_name("GOALS");
  verb.add_option("--games", options.games,
                  fmt::format("The most games to play. Default: {}.", options.games))
      ->type_name("N");
  verb.add_option("--rules", options.rules,
                  fmt::format("The rule book. Default: {}.", options.rules))
      ->type_name("BOOK");
  verb.add_option("--camera", options.camera,
                  "Vision and radio, as in the setting sim.camera. Default: that of AutoRef.")
      ->type_name("CAMERA");
  verb.add_option("--seed", options.seed, "Seed of the games. Default: 1.")->type_name("N");
  add_set_option(verb, options.sets,
                 "Change a setting of a team, such as new.params.shot_mps=5 or old.robots=5, or "
                 "of all games, such as match.half_s=60. May be repeated.");
}

}  // namespace

void add_compare_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("compare", "Find out which of two teams is better.");
  auto options = std::make_shared<CompareOptions>();
  add_team_arguments(*verb, *options);
  add_game_options(*verb, *options);
  verb->add_option(
          "--require", options->required,
          "When to exit with 0 instead of 1: unless NEW is worse (not-worse, the default), "
          "if NEW is better or equal (equal), or only if it is better (better).")
      ->type_name("OUTCOME")
      ->check(one_of(requirement_words()));
  verb->add_option(
          "--ci", options->ci_folder,
          "Write the answer for continuous integration into this folder: comparison.md for "
          "a comment or a summary, and junit.xml for test reports.")
      ->type_name("DIR");
  verb->add_option(
          "--reuse", options->reused_folder,
          "Take over games from this folder of an earlier comparison, if the same programs "
          "played them with the same settings. It may be missing.")
      ->type_name("DIR");
  verb->add_flag("--scenario", options->is_scenario_asked,
                 "Print the comparison as a scenario for autoref run, and play nothing.");
  add_json_flag(*verb, options->json);
  verb->add_option("-o,--output", options->folder,
                   "Folder for the results. Default: one in results/runs for each comparison.")
      ->type_name("DIR");
  add_workers_option(*verb, options->workers);
  add_run_options(*verb, *options);
  verb->footer(
      "Both teams play each other in pairs of legs, and the opponents of --against with the same\n"
      "seeds, until the 95 % interval of the difference decides: it excludes 0 (better or worse),\n"
      "or it lies within --least (no difference that matters). The interval allows for looking\n"
      "after every pair. Repeat a command to continue it, with more --games if it was "
      "undecided.\n\n"
      "Examples:\n"
      "  autoref compare basic counter\n"
      "  autoref compare basic --set new.params.kick_caution=0.7\n"
      "  autoref compare 'python3 old/my_team.py' 'python3 my_team.py' --against basic,counter");
  choose(*verb, chosen, options, compare_verb);
}

}  // namespace autoref::app
