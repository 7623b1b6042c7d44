#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "runner/batch/result_folder.hpp"
#include "runner/cli/command_line.hpp"
#include "runner/cli/judged_results.hpp"
#include "runner/io/errors.hpp"
#include "runner/io/terminal.hpp"
#include "runner/report/folder_report.hpp"
#include "runner/report/report.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

void print_files(const ExperimentResults& results, const WrittenReport& report,
                 const fs::path& into) {
  fmt::print("{}   one row per game\n", (into / kResultsFile).string());
  for (const ResultFile& file : results.files) {
    fmt::print("{}   {}\n", (into / file.name).string(), file.about);
  }
  fmt::print("{}   the report\n", (into / kMarkdownReport).string());
  fmt::print("{}   the same as a single page for a browser\n", (into / kHtmlReport).string());
  fmt::print("{}   {} plots, their data and scripts\n", (into / kPlotsFolder).string(),
             report.drawn);
}

void print_report(const FolderReport& written) {
  const ResultFolder& folder = written.folder;
  fmt::print("{}\n", text_of(written.results.table, text_width(stdout)));
  if (!folder.is_complete()) {
    fmt::print("{} of {} games: do not stop early because of interim intervals\n",
               folder.completed_games.done.size(), folder.needed);
  }
  if (written.report) {
    print_files(written.results, *written.report, written.into);
    for (const std::string& trouble : written.report->troubles)
      write_message(stderr, "autoref: " + trouble + "\n");
  } else {
    fmt::print(
        "nothing is written, since {} would lose games: restore their rows, let autoref run play "
        "them "
        "again, or pass --allow-fewer to write it without them\n",
        (written.into / kResultsFile).string());
  }
}

ExitCode print_faults(const std::set<std::string>& faults) {
  for (const std::string& fault : faults) write_message(stderr, "autoref: " + fault + "\n");
  return faults.empty() ? kDone : kDifferent;
}

}  // namespace

int report_verb(const ReportArguments& arguments) {
  const fs::path path = arguments.folder;
  const LostGames lost = arguments.allow_fewer ? LostGames::kDrop : LostGames::kKeep;
  if (is_judged(scenario_in(path))) {
    return print_faults(report_judged_builds(path, arguments.build, lost));
  }
  const std::vector<FolderReport> reports = write_folder_reports(path, arguments.build, lost);
  std::set<std::string> faults;
  for (const FolderReport& report : reports) {
    if (reports.size() > 1) fmt::print("build {}\n\n", report.folder.build);
    print_report(report);
    if (reports.size() > 1) fmt::print("\n");
    faults.merge(report.folder.faults());
  }
  if (reports.size() > 1) {
    fmt::print("{}   overview with links to each build's report\n",
               (path / kMarkdownReport).string());
  }
  return print_faults(faults);
}

void add_report_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "report", "Merge the rows of all shards in a folder; write tables, report and plots.");
  auto arguments = std::make_shared<ReportArguments>();
  add_folder_options(*verb, *arguments);
  verb->add_flag("--allow-fewer", arguments->allow_fewer,
                 "Write the results even if games of results.csv have no rows any more.");
  verb->footer(
      "Safe to use while a run is filling the folder; the same rows give the same files. Plots\n"
      "need gnuplot (apt-get install gnuplot-nox); DIR/plots always has their data and scripts.\n"
      "Games of several builds are reported separately, in folders DIR/build-... An existing\n"
      "report is updated when a run completes the folder.\n\n"
      "Example:\n  autoref report results/runs/handicap-speed");
  verb->callback(
      [arguments, &chosen] { chosen = [arguments] { return report_verb(*arguments); }; });
}

}  // namespace autoref::runner
