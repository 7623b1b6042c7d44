#include "experiments/report/folder_report.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <optional>

#include "experiments/report/document.hpp"
#include "experiments/report/report.hpp"
#include "experiments/report/sections.hpp"
#include "io/checksum.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

namespace fs = std::filesystem;

bool is_letter_of_builds(char c) {
  const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  return is_letter || (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_' || c == '+';
}

std::string folder_name(const std::string& build) { return "build-" + build; }

Table table_of(const std::vector<BuildReport>& builds) {
  Table table{{{"build", "games", "of", "void"}}, 1};
  for (const auto& [folder, text] : builds) {
    table.rows.push_back({folder.build, std::to_string(folder.completed_games.done.size()),
                          std::to_string(folder.games.size()),
                          std::to_string(folder.void_games())});
  }
  return table;
}

FolderReport write_one(ResultFolder folder, const fs::path& into, LostGames lost) {
  if (lost == LostGames::kKeep && !folder.lost.empty()) {
    ExperimentResults results = folder.scenario.experiment().results(folder.completed_games.done);
    return {std::move(folder), into, std::move(results), std::nullopt};
  }
  io::create_folder(into);
  ExperimentResults results =
      write_results(into, folder.scenario, folder.format, folder.completed_games.done);
  const WrittenReport report = write_report(folder, results, into);
  return {std::move(folder), into, std::move(results), report};
}

// The value in a two-cell row of report.md; empty if there is no such row.
std::string cell_in(const std::string& markdown, std::string_view name) {
  const std::string begin = fmt::format("\n| {} | ", name);
  const std::size_t at = markdown.find(begin);
  if (at == std::string::npos) return {};
  const std::size_t value = at + begin.size();
  return markdown.substr(value, markdown.find(" |\n", value) - value);
}

// The state recorded in a report.
struct ReportState {
  fs::path into;
  std::string build;
  std::string games;     // "12 of 24"
  std::string checksum;  // checksum of the rows
};

// Reads the state of one build's report; an overview of several builds does not count.
std::optional<ReportState> report_in(const fs::path& into, const std::string& build) {
  const std::string text = io::read_file(into / kMarkdownReport).value_or("");
  ReportState state{into, cell_in(text, kBuildRow), cell_in(text, kGamesRow),
                    cell_in(text, kChecksumRow)};
  return !state.games.empty() && state.build == build ? std::optional(state) : std::nullopt;
}

std::optional<ReportState> state_of_report(const ResultFolder& folder) {
  if (auto state = report_in(folder.path, folder.build)) return state;
  return folder.build.empty() ? std::nullopt
                              : report_in(build_folder(folder.path, folder.build), folder.build);
}

bool is_stale(const ReportState& state, const ResultFolder& folder) {
  if (state.games != games_text(folder)) return true;
  // The number of games alone does not change when games are replaced by others.
  return state.checksum != rows_checksum(folder);
}

}  // namespace

fs::path build_folder(const fs::path& path, const std::string& build) {
  if (std::all_of(build.begin(), build.end(), is_letter_of_builds)) {
    return path / folder_name(build);
  }
  throw io::InputError(
      {(path / kGamesFolder).string()}, "build",
      fmt::format("a row's build may only contain letters, digits and .-_+; found '{}'; move "
                  "the file with this row elsewhere",
                  build));
}

void write_overview(const fs::path& path, const std::vector<BuildReport>& builds) {
  Document document{
      title_of(builds.front().folder.scenario),
      {Paragraph{"The folder holds games of several builds. Games of different builds "
                 "do not belong to the same experiment, so each build is reported separately. "
                 "Tables and plots in the same folder as this report, if any, are those of the "
                 "build reported last."},
       table_of(builds)}};
  for (const auto& [folder, text] : builds) {
    document.blocks.emplace_back(Heading{"Build " + folder.build});
    document.blocks.emplace_back(Verbatim{text});
    for (const char* file : {kMarkdownReport, kHtmlReport}) {
      document.blocks.emplace_back(
          Link{fmt::format("{}/{}", folder_name(folder.build), file), file});
    }
  }
  io::replace_file(path / kMarkdownReport, markdown_of(document));
  io::replace_file(path / kHtmlReport, html_of(document));
}

std::vector<FolderReport> write_folder_reports(const fs::path& path, const std::string& build,
                                               LostGames lost) {
  std::vector<FolderReport> reports;
  const std::set<std::string> builds = builds_in(path);
  if (!build.empty() || builds.size() <= 1) {
    reports.push_back(write_one(open_results(path, build), path, lost));
    return reports;
  }
  std::vector<BuildReport> overview;
  for (const std::string& each : builds) {
    reports.push_back(write_one(open_results(path, each), build_folder(path, each), lost));
    overview.push_back({reports.back().folder, io::text_of(reports.back().results.table)});
  }
  write_overview(path, overview);
  return reports;
}

std::string report_shortfall(const ResultFolder& folder) {
  const std::optional<ReportState> state = state_of_report(folder);
  if (!state || !is_stale(*state, folder)) return {};
  const auto done = static_cast<int>(folder.completed_games.done.size());
  const int lacks =
      done - io::whole_number_in(state->games.substr(0, state->games.find(' '))).value_or(0);
  return fmt::format(
      "{} {}; update it with: autoref report {}", (state->into / kHtmlReport).string(),
      lacks > 0 ? fmt::format("lacks {} of the {} games", lacks, done)
                : std::string("does not cover the same games as the folder now contains"),
      folder.path.string());
}

fs::path refresh_report(const ResultFolder& folder) {
  const std::optional<ReportState> state = state_of_report(folder);
  if (!state || !is_stale(*state, folder)) return {};
  const std::vector<FolderReport> reports =
      write_folder_reports(folder.path, state->into == folder.path ? folder.build : "");
  return reports.front().report ? state->into / kHtmlReport : fs::path();
}

}  // namespace autoref::experiments
