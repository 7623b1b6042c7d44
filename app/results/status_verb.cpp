#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/results/folder_arguments.hpp"
#include "app/results/judged_results.hpp"
#include "app/verbs.hpp"
#include "experiments/report/folder_report.hpp"
#include "experiments/report/sections.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"
#include "judge/judged_rows.hpp"

namespace autoref::app {
namespace {

void print_counts(const experiments::ResultFolder& folder) {
  fmt::print("{}   {} of {} games done, {} void\n", folder.path.string(),
             folder.completed_games.done.size(), folder.needed, folder.void_games());
  if (folder.completed_games.other_games > 0) {
    fmt::print("  {} rows do not belong to any game of the experiment and do not count\n",
               folder.completed_games.other_games);
  }
  if (folder.beyond > 0) {
    fmt::print("  {} games were played after the match was decided and do not count\n",
               folder.beyond);
  }
  for (const auto& [shard, count] : folder.by_shard) {
    fmt::print("  shard {}   {} games\n", shard, count);
  }
  for (const auto& [build, count] : folder.completed_games.other_builds) {
    fmt::print("  build {}   {} rows, not counted here\n", build, count);
  }
  if (folder.killed_games() > 0) {
    fmt::print(
        "  {} games are void because their workers were killed; autoref run plays them again\n",
        folder.killed_games());
  }
  const std::string shortfall = experiments::report_shortfall(folder);
  if (!shortfall.empty()) fmt::print("  {}\n", shortfall);
  for (const std::string& fault : folder.faults()) fmt::print("  {}\n", fault);
}

int status_verb(const FolderArguments& arguments) {
  const experiments::ResultFolder folder =
      experiments::open_results(arguments.folder, arguments.build);
  print_counts(folder);
  if (is_judged(folder.scenario)) {
    fmt::print("\n");
    print_judged_scores(judge::report_of(folder));
    return io::kDone;
  }
  const experiments::ExperimentResults results =
      folder.scenario.experiment().results(folder.completed_games.done);
  fmt::print("\n{}", io::text_of(results.table, io::text_width(stdout)));
  if (!folder.is_complete() && !results.groups.empty() && !results.comparison) {
    fmt::print("\n{}\n", experiments::kInterimWarning);
  }
  return io::kDone;
}

}  // namespace

void add_status_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb =
      app.add_subcommand("status", "Print an experiment's progress and its current table.");
  auto arguments = std::make_shared<FolderArguments>();
  add_folder_options(*verb, *arguments);
  verb->footer("Example:\n  autoref results status results/runs/handicap-speed");
  choose(*verb, chosen, arguments, status_verb);
}

}  // namespace autoref::app
