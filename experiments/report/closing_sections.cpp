#include <fmt/format.h>

#include "experiments/report/default_differences.hpp"
#include "experiments/report/sections.hpp"
#include "experiments/results/scores.hpp"

namespace autoref::experiments {
namespace {

constexpr std::size_t kMostVoidGames = 20;  // listed one by one

std::string effective_file(const std::string& direction) {
  return direction == "." ? kEffectiveFile : fmt::format("{}/{}", direction, kEffectiveFile);
}

}  // namespace

Section void_section(const ResultFolder& folder) {
  List list;
  std::size_t others = 0;
  for (const auto& [id, row] : folder.completed_games.done) {
    if (!is_void(row.record)) continue;
    if (list.items.size() == kMostVoidGames) {
      ++others;
    } else {
      list.items.push_back(fmt::format("{}: {}", id, row.record.void_reason));
    }
  }
  if (list.items.empty()) return {};
  if (others > 0) list.items.push_back(fmt::format("and {} more, in results.csv", others));
  return {
      Heading{"Void games"},
      Paragraph{"Void games do not count in means or intervals; the other leg of their pair counts "
                "in means, but not in intervals."},
      list};
}

Section settings_section(const ResultFolder& folder, const std::string& direction) {
  const std::vector<DefaultDifference> differences =
      differences_from_defaults(folder.scenario.experiment());
  Table table{{{"setting", "value", "default"}}, 3};
  for (const DefaultDifference& difference : differences) {
    table.rows.push_back({difference.path, difference.here, difference.by_default});
  }
  Section section = {Heading{"Settings"}, Link{effective_file(direction), "All settings"}};
  if (!differences.empty()) {
    const Paragraph intro{"Differences from the defaults of the rule book:"};
    section.emplace_back(intro);
    section.emplace_back(table);
  }
  return section;
}

Section commands_section(const ResultFolder& folder, const std::string& direction) {
  const std::string folder_and_build =
      direction + (folder.completed_games.other_builds.empty() ? "" : " --build " + folder.build);
  return {
      Heading{"How to reproduce"},
      Paragraph{
          fmt::format("Run these in the folder of this report, with build {}, to play all games "
                      "again, to replay five and compare them, and to write the report again:",
                      folder.build)},
      Verbatim{fmt::format("autoref {2} {0} -o again\n"
                           "autoref verify {1} --sample 5\n"
                           "autoref report {1}\n",
                           effective_file(direction), folder_and_build, verb_of(folder.scenario))}};
}

}  // namespace autoref::experiments
