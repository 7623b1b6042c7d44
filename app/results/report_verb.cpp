#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/results/folder_arguments.hpp"
#include "app/results/judged_results.hpp"
#include "app/verbs.hpp"
#include "experiments/report/folder_report.hpp"
#include "experiments/report/report.hpp"
#include "experiments/run/result_folder.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"

namespace autoref::app {
namespace {

struct ReportArguments : FolderArguments {
  bool allow_fewer = false;  // whether the new results.csv may have fewer games
};

namespace fs = std::filesystem;

void print_files(const experiments::ExperimentResults& results,
                 const experiments::WrittenReport& report, const fs::path& into) {
  fmt::print("{}   one row per game\n", (into / experiments::kResultsFile).string());
  for (const experiments::ResultFile& file : results.files) {
    fmt::print("{}   {}\n", (into / file.name).string(), file.about);
  }
  fmt::print("{}   the report\n", (into / experiments::kMarkdownReport).string());
  fmt::print("{}   the same report as a single page for a browser\n",
             (into / experiments::kHtmlReport).string());
  fmt::print("{}   {} plots, their data and scripts\n", (into / experiments::kPlotsFolder).string(),
             report.drawn);
}

void print_report(const experiments::FolderReport& written) {
  const experiments::ResultFolder& folder = written.folder;
  fmt::print("{}\n", io::text_of(written.results.table, io::text_width(stdout)));
  if (!folder.is_complete()) {
    fmt::print(
        "{} of {} games{}\n", folder.completed_games.done.size(), folder.needed,
        written.results.comparison ? "" : ": do not stop early because of interim intervals");
  }
  if (written.report) {
    print_files(written.results, *written.report, written.into);
    for (const std::string& trouble : written.report->troubles)
      io::write_message(stderr, "autoref: " + trouble + "\n");
  } else {
    fmt::print(
        "nothing was written because {} would lose games: restore their rows, run autoref run to "
        "play them again, or pass --allow-fewer to write it without them\n",
        (written.into / experiments::kResultsFile).string());
  }
}

io::ExitCode print_faults(const std::set<std::string>& faults) {
  for (const std::string& fault : faults) io::write_message(stderr, "autoref: " + fault + "\n");
  return faults.empty() ? io::kDone : io::kDifferent;
}

int report_verb(const ReportArguments& arguments) {
  const fs::path path = arguments.folder;
  const experiments::LostGames lost =
      arguments.allow_fewer ? experiments::LostGames::kDrop : experiments::LostGames::kKeep;
  if (is_judged(experiments::scenario_in(path))) {
    return print_faults(report_judged_builds(path, arguments.build, lost));
  }
  const std::vector<experiments::FolderReport> reports =
      experiments::write_folder_reports(path, arguments.build, lost);
  std::set<std::string> faults;
  for (const experiments::FolderReport& report : reports) {
    if (reports.size() > 1) fmt::print("build {}\n\n", report.folder.build);
    print_report(report);
    if (reports.size() > 1) fmt::print("\n");
    faults.merge(report.folder.faults());
  }
  if (reports.size() > 1) {
    fmt::print("{}   overview with links to each build's report\n",
               (path / experiments::kMarkdownReport).string());
  }
  return print_faults(faults);
}

}  // namespace

void add_report_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand(
      "report", "Merge the rows of all shards in a folder; write tables, report and plots.");
  auto arguments = std::make_shared<ReportArguments>();
  add_folder_options(*verb, *arguments);
  verb->add_flag("--allow-fewer", arguments->allow_fewer,
                 "Write the results even if games in results.csv no longer have rows.");
  verb->footer(
      "Safe to use while a run is filling the folder; the same rows give the same files. Plots\n"
      "need gnuplot (apt-get install gnuplot-nox); DIR/plots always has their data and scripts.\n"
      "Games of several builds are reported separately, in folders DIR/build-... An existing\n"
      "report is updated when a run completes the folder.\n\n"
      "Example:\n  autoref report results/runs/handicap-speed");
  choose(*verb, chosen, arguments, report_verb);
}

}  // namespace autoref::app
