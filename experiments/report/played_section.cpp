#include <fmt/format.h>

#include "experiments/report/sections.hpp"
#include "io/checksum.hpp"
#include "io/words.hpp"

namespace autoref::experiments {
namespace {

std::string kind_text(const Scenario& scenario) {
  const std::vector<std::string> factors = scenario.experiment().value_columns();
  return factors.empty() ? std::string(kind_of(scenario))
                         : fmt::format("{} of {}", kind_of(scenario), io::listed(factors));
}

std::size_t pairs_of(const std::vector<Group>& groups) {
  std::size_t pairs = 0;
  for (const Group& group : groups) pairs += group.pair_differences.size();
  return pairs;
}

// Adds a table row for each kind of rows that do not count, if there are any.
void add_rows_that_do_not_count(Table& table, const ResultFolder& folder) {
  if (!folder.damaged.empty()) {
    table.rows.push_back({"damaged rows (not counted)", std::to_string(folder.damaged.size())});
  }
  if (folder.completed_games.other_games > 0) {
    table.rows.push_back({"rows that belong to no game of the experiment",
                          std::to_string(folder.completed_games.other_games)});
  }
  for (const auto& [build, count] : folder.completed_games.other_builds) {
    table.rows.push_back({"rows of build " + build + " (not counted here)", std::to_string(count)});
  }
}

}  // namespace

std::string games_text(const ResultFolder& folder) {
  return fmt::format("{} of {}", folder.completed_games.done.size(), folder.needed);
}

std::string rows_checksum(const ResultFolder& folder) {
  return io::crc_text(results_csv(folder.format, folder.completed_games.done));
}

Section played_section(const ResultFolder& folder, const ExperimentResults& results) {
  Table table{{{"experiment", ""},
               {"kind", kind_text(folder.scenario)},
               {kGamesRow, games_text(folder)},
               {"void games", std::to_string(folder.void_games())},
               {kBuildRow, folder.build.empty() ? "none" : folder.build},
               {"master seed", seed_text(folder.scenario.experiment())},
               {kChecksumRow, rows_checksum(folder)}},
              2};
  if (!results.groups.empty()) {
    table.rows.push_back(
        {"pairs of legs without a void game", std::to_string(pairs_of(results.groups))});
  }
  add_rows_that_do_not_count(table, folder);
  Section section = {Heading{"What was played"}, table};
  if (!folder.is_complete()) {
    section.emplace_back(Paragraph{fmt::format("{} games are missing. {}",
                                               folder.needed - folder.completed_games.done.size(),
                                               kInterimWarning)});
  }
  return section;
}

}  // namespace autoref::experiments
