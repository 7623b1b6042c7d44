#include "app/results/judged_results.hpp"

#include <fmt/format.h>

#include "experiments/report/folder_report.hpp"
#include "experiments/report/report.hpp"
#include "io/files.hpp"
#include "io/terminal.hpp"
#include "judge/judge_document.hpp"
#include "judge/judged_rows.hpp"

namespace autoref::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJudgeFile = "judge.csv";
constexpr const char* kFaultsFile = "faults.csv";

}  // namespace

bool is_judged(const experiments::Scenario& scenario) {
  return scenario.experiment().row_kind() == experiments::RowKind::kJudged;
}

void write_judged(const fs::path& folder, const judge::JudgeReport& report) {
  io::replace_file(folder / kJudgeFile, judge::csv_of(report));
  io::replace_file(folder / kFaultsFile, report.faults_csv);
}

void print_judged(const judge::JudgeReport& report) {
  fmt::print("{}\n", io::is_terminal(stdout)
                         ? io::text_of(judge::blocks_of(report), io::text_width(stdout))
                         : judge::markdown_of(report));
}

void print_judged_scores(const judge::JudgeReport& report) {
  fmt::print("{}", io::is_terminal(stdout)
                       ? io::text_of(judge::scores_text_of(report), io::text_width(stdout))
                       : judge::scores_markdown_of(report));
}

void print_judged_files(const fs::path& folder) {
  fmt::print("{}\n{}   one row per missed event or wrong call\n", (folder / kJudgeFile).string(),
             (folder / kFaultsFile).string());
}

std::string report_judged(const experiments::ResultFolder& folder, const fs::path& into,
                          experiments::LostGames lost) {
  const judge::JudgeReport report = judge::report_of(folder);
  if (lost == experiments::LostGames::kKeep && !folder.damaged.empty()) {
    print_judged(report);
    fmt::print(
        "nothing was written because rows are damaged: run autoref judge to play their games "
        "again, or pass --allow-fewer\n");
    return judge::scores_markdown_of(report);
  }
  write_judged(into, report);
  const experiments::Document document =
      judge::judge_document(folder, report, into == folder.path ? "." : "..");
  io::replace_file(into / experiments::kMarkdownReport, experiments::markdown_of(document));
  io::replace_file(into / experiments::kHtmlReport, experiments::html_of(document));
  print_judged(report);
  if (!folder.is_complete()) {
    fmt::print("{} of {} games so far\n", folder.completed_games.done.size(), folder.needed);
  }
  print_judged_files(into);
  fmt::print("{}   the report\n{}   the same report as a single page for a browser\n",
             (into / experiments::kMarkdownReport).string(),
             (into / experiments::kHtmlReport).string());
  return judge::scores_markdown_of(report);
}

std::set<std::string> report_judged_builds(const fs::path& path, const std::string& build,
                                           experiments::LostGames lost) {
  const std::set<std::string> builds = experiments::builds_in(path);
  if (!build.empty() || builds.size() <= 1) {
    const experiments::ResultFolder folder = experiments::open_results(path, build);
    report_judged(folder, path, lost);
    return folder.faults();
  }
  std::set<std::string> faults;
  std::vector<experiments::BuildReport> overview;
  for (const std::string& each : builds) {
    const fs::path into = experiments::build_folder(path, each);
    io::create_folder(into);
    fmt::print("build {}\n\n", each);
    const experiments::ResultFolder folder = experiments::open_results(path, each);
    overview.push_back({folder, report_judged(folder, into, lost)});
    faults.merge(folder.faults());
    fmt::print("\n");
  }
  experiments::write_overview(path, overview);
  fmt::print("{}   overview with links to each build's report\n",
             (path / experiments::kMarkdownReport).string());
  return faults;
}

}  // namespace autoref::app
