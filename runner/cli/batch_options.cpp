// What the verbs of many games have in common.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "runner/batch/experiment_kinds.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/experiments/reading/scenario_reader.hpp"
#include "runner/io/errors.hpp"
#include "runner/processes/workers.hpp"

namespace autoref::runner {

std::filesystem::path BatchArguments::results_folder() const {
  if (!folder.empty()) return folder;
  return std::filesystem::path("results/runs") / std::filesystem::path(file).stem();
}

int BatchArguments::worker_count() const { return workers > 0 ? workers : processors(); }

Scenario read_experiment(const BatchArguments& arguments) {
  Scenario scenario = read_scenario(arguments.file, assignments_in(arguments.sets));
  if (is_experiment(scenario)) return scenario;
  throw InputError({arguments.file}, "kind",
                   fmt::format("this is a {}, not an experiment; play it with: autoref {} {}",
                               kind_of(scenario), verb_of(scenario), arguments.file));
}

void add_set_option(CLI::App& verb, std::vector<std::string>& sets) {
  verb.add_option("--set", sets,
                  "Change a setting, such as match.half_s=60 or b.robots=5 (of a team with a name: "
                  "teams.NAME.robots=5). May be repeated.")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_batch_options(CLI::App& verb, BatchArguments& arguments, const std::string& about_file) {
  verb.add_option("FILE", arguments.file, about_file)->required();
  verb.add_option("-o,--output", arguments.folder,
                  "Folder for the results. Default: results/runs/<scenario>.")
      ->type_name("DIR");
  verb.add_option("-j,--workers", arguments.workers,
                  "Games played at a time. Default: one per processor.")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  add_set_option(verb, arguments.sets);
}

void add_folder_options(CLI::App& verb, FolderArguments& arguments) {
  verb.add_option("DIR", arguments.folder,
                  "Folder of results, as autoref run and autoref judge leave it.")
      ->required();
  verb.add_option("--build", arguments.build,
                  "Build whose games count, where the folder holds games of several.")
      ->type_name("BUILD");
}

}  // namespace autoref::runner
