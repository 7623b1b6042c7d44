#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <set>
#include <vector>

#include "runner/batch/result_folder.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/cli/judged_results.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/files.hpp"
#include "runner/report/build_reports.hpp"
#include "runner/report/report.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

void print_files(const ExperimentResults& results, const WrittenReport& report,
                 const fs::path& into) {
  fmt::print("{}   a row per game\n", (into / kResultsFile).string());
  for (const ResultFile& file : results.files) {
    fmt::print("{}   {}\n", (into / file.name).string(), file.about);
  }
  fmt::print("{}   the report\n", (into / kMarkdownReport).string());
  fmt::print("{}   the same, one page for a browser\n", (into / kHtmlReport).string());
  fmt::print("{}   {} plots, their data and scripts\n", (into / kPlotsFolder).string(),
             report.drawn);
}

// Writes everything that follows from one build's rows into `into`, and says so. Gives its table.
std::string report_build(const ResultFolder& folder, const fs::path& into) {
  create_folder(into);
  if (is_judged(folder.scenario)) return report_judged(folder, into);
  const ExperimentResults results =
      write_results(into, folder.scenario, folder.format, folder.completed_games.done);
  const WrittenReport report = write_report(folder, results, into);
  fmt::print("{}\n", results.table);
  if (!folder.is_complete()) {
    fmt::print("{} of {} games: interim intervals are no reason to stop\n",
               folder.completed_games.done.size(), folder.needed);
  }
  print_files(results, report, into);
  for (const std::string& trouble : report.troubles)
    write_message(stderr, "autoref: " + trouble + "\n");
  return results.table;
}

void report_each_build(const fs::path& path, const std::set<std::string>& builds) {
  std::vector<BuildReport> reports;
  for (const std::string& build : builds) {
    fmt::print("build {}\n\n", build);
    BuildReport report{open_results(path, build), {}};
    report.table = report_build(report.folder, build_folder(path, build));
    reports.push_back(std::move(report));
    fmt::print("\n");
  }
  write_overview(path, reports);
  fmt::print("{}   where each build's report is\n", (path / kMarkdownReport).string());
}

}  // namespace

int report_verb(const FolderArguments& arguments) {
  const fs::path path = arguments.folder;
  const std::set<std::string> builds = builds_in(path);
  if (arguments.build.empty() && builds.size() > 1) {
    report_each_build(path, builds);
  } else {
    report_build(open_results(path, arguments.build), path);
  }
  return kDone;
}

void add_report_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "report", "Merge a folder's rows, of all its shards, and write tables, report and plots.");
  auto arguments = std::make_shared<FolderArguments>();
  add_folder_options(*verb, *arguments);
  verb->footer(
      "Safe while a run is filling the folder; the same rows give the same files. Plots need\n"
      "gnuplot (apt-get install gnuplot-nox); DIR/plots has their data and scripts in any case.\n"
      "Games of several builds are reported apart, in folders DIR/build-...\n\n"
      "Example:\n  autoref report results/runs/handicap-speed");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return report_verb(*arguments); }; });
}

}  // namespace autoref::runner
