#include "experiments/report/build_reports.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/report/document.hpp"
#include "experiments/report/report.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

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

}  // namespace autoref::experiments
