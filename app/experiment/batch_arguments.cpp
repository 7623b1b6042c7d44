#include "app/experiment/batch_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/scenario_argument.hpp"
#include "app/shared_options.hpp"
#include "experiments/kinds/all_kinds.hpp"
#include "experiments/kinds/scenario_reader.hpp"
#include "experiments/run/earlier_versions.hpp"
#include "experiments/run/program_versions.hpp"
#include "game/settings/assignments.hpp"
#include "io/build_id.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"

namespace autoref::app {
namespace {

constexpr std::string_view kRun = "run";

void override_pairs(const std::string& text, experiments::Scenario& scenario) {
  if (text.empty()) return;
  const std::optional<int> pairs = io::whole_number_in(text);
  if (!pairs) {
    throw io::InputError({"--pairs"}, "",
                         fmt::format("expected a whole number from 1 to {}, found '{}'",
                                     experiments::kMostPairs, text));
  }
  game::locate_errors("--pairs", [&] { experiments::set_pairs(scenario.experiment(), *pairs); });
}

}  // namespace

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

std::filesystem::path BatchArguments::results_folder() const {
  if (!folder.empty()) return folder;
  return std::filesystem::path("results/runs") / std::filesystem::path(file).stem();
}

experiments::Scenario read_experiment(const BatchArguments& arguments) {
  const std::string& file = arguments.file;
  experiments::Scenario scenario =
      experiments::read_scenario(file, game::assignments_in(arguments.sets));
  const std::string_view verb = experiments::verb_of(scenario);
  if (verb != kRun) {
    throw io::InputError(
        {file}, "kind",
        fmt::format("this file is of kind {}, not an experiment; play it with: autoref {} {}",
                    experiments::kind_of(scenario), verb, file));
  }
  override_pairs(arguments.pairs, scenario);
  override_seed(arguments.seed, scenario);
  experiments::note_program_versions(scenario);
  experiments::take_over_versions(scenario, std::string(io::build_id()));
  return scenario;
}

void add_experiment_argument(CLI::App& verb, BatchArguments& arguments,
                             const std::string& verb_name) {
  add_scenario_argument(
      verb, arguments.file,
      fmt::format("Scenario of kind {}.", experiments::kinds_played_by(verb_name)));
}

void add_batch_options(CLI::App& verb, BatchArguments& arguments) {
  verb.add_option("-o,--output", arguments.folder,
                  "Folder for the results. Default: results/runs/<scenario>.")
      ->type_name("DIR");
  add_workers_option(verb, arguments.workers);
  add_set_option(verb, arguments.sets);
}

void add_override_options(CLI::App& verb, BatchArguments& arguments) {
  verb.add_option("--pairs", arguments.pairs,
                  "Pairs of legs, overriding the file; for kinds compare and sprt, the maximum.")
      ->type_name("N");
  verb.add_option("--seed", arguments.seed, "Seed of the experiment, overriding the file.")
      ->type_name("N");
}

void print_rule_notes(const experiments::ExperimentReport& report) {
  const std::size_t width = io::text_width(stdout);
  for (const std::string& note : report.rule_notes) fmt::print("{}\n", io::wrapped(note, width));
  if (!report.rule_notes.empty()) fmt::print("\n");
}

}  // namespace autoref::app
