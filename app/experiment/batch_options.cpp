// Options shared by the verbs that play many games.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/command_line.hpp"
#include "app/scenario_argument.hpp"
#include "experiments/kinds/all_kinds.hpp"
#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/program_versions.hpp"
#include "game/settings/assignments.hpp"
#include "io/errors.hpp"
#include "io/processes/workers.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

void override_pairs(const std::string& text, experiments::Scenario& scenario) {
  if (text.empty()) return;
  const std::optional<int> pairs = io::whole_number_in(text);
  if (!pairs) {
    throw io::InputError({"--pairs"}, "",
                         fmt::format("expected a whole number from 1 to {}, found '{}'",
                                     experiments::kMostPairs, text));
  }
  game::blame("--pairs", [&] { experiments::set_pairs(scenario.experiment(), *pairs); });
}

void override_seed(const std::string& text, experiments::Scenario& scenario) {
  if (text.empty()) return;
  const std::optional<std::uint64_t> seed = io::seed_in(text);
  if (!seed) {
    throw io::InputError(
        {"--seed"}, "",
        fmt::format("expected a whole number from 0 to 2^64 - 1, found '{}'", text));
  }
  experiments::set_master_seed(scenario.experiment(), *seed);
}

}  // namespace

std::filesystem::path BatchArguments::results_folder() const {
  if (!folder.empty()) return folder;
  return std::filesystem::path("results/runs") / std::filesystem::path(file).stem();
}

int BatchArguments::worker_count() const { return workers > 0 ? workers : io::processors(); }

experiments::Scenario read_experiment(const BatchArguments& arguments) {
  const std::string& file = arguments.file;
  experiments::Scenario scenario =
      experiments::read_scenario(file, game::assignments_in(arguments.sets));
  const std::string_view verb = experiments::verb_of(scenario);
  if (std::find(arguments.verbs.begin(), arguments.verbs.end(), verb) == arguments.verbs.end()) {
    throw io::InputError(
        {file}, "kind",
        fmt::format("this is of kind {}, not {}; play it with: autoref {} {}",
                    experiments::kind_of(scenario),
                    arguments.verbs.front() == "tune" ? "a tuning" : "an experiment", verb, file));
  }
  override_pairs(arguments.pairs, scenario);
  override_seed(arguments.seed, scenario);
  experiments::note_program_versions(scenario);
  return scenario;
}

void add_set_option(CLI::App& verb, std::vector<std::string>& sets) {
  verb.add_option("--set", sets,
                  "Change a setting, such as match.half_s=60 or b.robots=5 (for a named team: "
                  "teams.NAME.robots=5). May be repeated.")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

std::string about_scenario(const std::vector<std::string>& verbs) {
  return fmt::format("Scenario of kind {}.", experiments::kinds_played_by(verbs));
}

void add_batch_options(CLI::App& verb, BatchArguments& arguments) {
  add_scenario_argument(verb, arguments.file, about_scenario(arguments.verbs));
  verb.add_option("-o,--output", arguments.folder,
                  "Folder for the results. Default: results/runs/<scenario>.")
      ->type_name("DIR");
  verb.add_option("-j,--workers", arguments.workers,
                  "Games played in parallel. Default: one per processor.")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  add_set_option(verb, arguments.sets);
}

void add_override_options(CLI::App& verb, BatchArguments& arguments) {
  verb.add_option("--pairs", arguments.pairs,
                  "Pairs of legs, overriding the file; for kind sprt, the maximum.")
      ->type_name("N");
  verb.add_option("--seed", arguments.seed, "Seed of the experiment, overriding the file.")
      ->type_name("N");
}

void add_folder_options(CLI::App& verb, FolderArguments& arguments) {
  verb.add_option("DIR", arguments.folder, "Results folder of autoref run or autoref judge.")
      ->required();
  verb.add_option("--build", arguments.build,
                  "Count only this build's games, if the folder holds games of several.")
      ->type_name("BUILD");
}

}  // namespace autoref::app
