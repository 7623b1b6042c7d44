#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "runner/errors.hpp"
#include "runner/result_folder.hpp"
#include "runner/verbs/command_line.hpp"

namespace autoref::runner {

int report_verb(const FolderArguments& arguments) {
  const ResultFolder folder = open_results(arguments.folder, arguments.build);
  const ExperimentResults results =
      write_results(folder.path, folder.scenario, folder.format, folder.stock.done);
  fmt::print("{}\n", results.table);
  if (!folder.is_complete()) {
    fmt::print("{} of {} games: interim intervals are no reason to stop\n",
               folder.stock.done.size(), folder.needed);
  }
  fmt::print("{}   a row per game\n", (folder.path / kResultsFile).string());
  for (const ResultFile& file : results.files) {
    fmt::print("{}   {}\n", (folder.path / file.name).string(), file.about);
  }
  return kDone;
}

void add_report_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "report", "Merge a folder's rows, of all its shards, and write what follows from them.");
  auto arguments = std::make_shared<FolderArguments>();
  add_folder_options(*verb, *arguments);
  verb->footer(
      "Safe while a run is filling the folder; the same rows give the same files.\n\n"
      "Example:\n  autoref report results/runs/handicap-speed");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return report_verb(*arguments); }; });
}

}  // namespace autoref::runner
