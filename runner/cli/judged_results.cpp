#include "runner/cli/judged_results.hpp"

#include <fmt/format.h>

#include "runner/io/files.hpp"
#include "runner/io/terminal.hpp"
#include "runner/judge/judged_rows.hpp"
#include "runner/report/build_reports.hpp"
#include "runner/report/judge_document.hpp"
#include "runner/report/report.hpp"

namespace autoref::runner {
namespace {

namespace fs = std::filesystem;

constexpr const char* kJudgeFile = "judge.csv";
constexpr const char* kFaultsFile = "faults.csv";

}  // namespace

bool is_judged(const Scenario& scenario) {
  return scenario.experiment().row_kind() == RowKind::kJudged;
}

void write_judged(const fs::path& folder, const JudgeReport& report) {
  replace_file(folder / kJudgeFile, csv_of(report));
  replace_file(folder / kFaultsFile, report.faults_csv);
}

void print_judged(const JudgeReport& report) {
  fmt::print("{}\n", is_terminal(stdout) ? text_of(blocks_of(report), text_width(stdout))
                                         : markdown_of(report));
}

void print_judged_scores(const JudgeReport& report) {
  fmt::print("{}", is_terminal(stdout) ? text_of(scores_text_of(report), text_width(stdout))
                                       : scores_markdown_of(report));
}

void print_judged_files(const fs::path& folder) {
  fmt::print("{}\n{}   one row per missed event or wrong call\n", (folder / kJudgeFile).string(),
             (folder / kFaultsFile).string());
}

std::string report_judged(const ResultFolder& folder, const fs::path& into, LostGames lost) {
  const JudgeReport report = report_of(folder);
  if (lost == LostGames::kKeep && !folder.damaged.empty()) {
    print_judged(report);
    fmt::print(
        "nothing is written, since rows are damaged: let autoref judge play their games again, or "
        "pass --allow-fewer\n");
    return scores_markdown_of(report);
  }
  write_judged(into, report);
  const Document document = judge_document(folder, report, into == folder.path ? "." : "..");
  replace_file(into / kMarkdownReport, markdown_of(document));
  replace_file(into / kHtmlReport, html_of(document));
  print_judged(report);
  if (!folder.is_complete()) {
    fmt::print("{} of {} games so far\n", folder.completed_games.done.size(), folder.needed);
  }
  print_judged_files(into);
  fmt::print("{}   the report\n{}   the same as a single page for a browser\n",
             (into / kMarkdownReport).string(), (into / kHtmlReport).string());
  return scores_markdown_of(report);
}

std::set<std::string> report_judged_builds(const fs::path& path, const std::string& build,
                                           LostGames lost) {
  const std::set<std::string> builds = builds_in(path);
  if (!build.empty() || builds.size() <= 1) {
    const ResultFolder folder = open_results(path, build);
    report_judged(folder, path, lost);
    return folder.faults();
  }
  std::set<std::string> faults;
  std::vector<BuildReport> overview;
  for (const std::string& each : builds) {
    const fs::path into = build_folder(path, each);
    create_folder(into);
    fmt::print("build {}\n\n", each);
    const ResultFolder folder = open_results(path, each);
    overview.push_back({folder, report_judged(folder, into, lost)});
    faults.merge(folder.faults());
    fmt::print("\n");
  }
  write_overview(path, overview);
  fmt::print("{}   overview with links to each build's report\n",
             (path / kMarkdownReport).string());
  return faults;
}

}  // namespace autoref::runner
