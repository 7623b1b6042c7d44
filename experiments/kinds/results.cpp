#include "experiments/kinds/results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "experiments/analysis/standings.hpp"
#include "experiments/analysis/team_differences.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {
namespace {

io::ProgressTable standings_progress_table(const std::vector<Standing>& standings,
                                           const std::string& noun) {
  const io::Cells to_spare = are_rated(standings)
                                 ? io::Cells{kStrengthHead, kGoalRatingHead, kGamesHead}
                                 : io::Cells{kGoalDifferenceHead, kGamesHead};
  std::vector<io::Cells> rows = standings_rows(standings);
  std::vector<std::size_t> dispensable = io::columns_named(rows.front(), to_spare);
  return {std::move(rows), kStandingsColumns, noun + "s", std::move(dispensable)};
}

}  // namespace

std::string name_of_round(std::size_t ties_in_round) {
  if (ties_in_round == 1) return "final";
  if (ties_in_round == 2) return "semi-finals";
  if (ties_in_round == 4) return "quarter-finals";
  return fmt::format("round of {}", 2 * ties_in_round);
}

io::ProgressTable groups_progress_table(std::vector<io::Cells> rows, std::vector<io::Align> columns,
                                        std::string noun) {
  std::vector<std::size_t> dispensable =
      io::columns_named(rows.front(), {kGoalsBHead, kGoalsAHead, kVoidHead});
  return {std::move(rows), std::move(columns), std::move(noun), std::move(dispensable)};
}

io::ProgressTable matchups_progress_table(const std::vector<Group>& matchups) {
  io::ProgressTable table =
      groups_progress_table(matchups_rows(matchups), kMatchupsColumns, "matchups");
  for (const std::size_t column :
       io::columns_named(table.rows.front(), {kGamesHead, kDifferenceHead}))
    table.dispensable.push_back(column);
  return table;
}

// Puts the standings first, since a small screen shows only the first part.
ExperimentResults tournament_results(std::vector<Group> matchups, std::vector<Standing> standings,
                                     const std::string& noun) {
  ExperimentResults results;
  results.files = {{"summary.csv", "a row per matchup", matchups_csv(matchups)},
                   {"standings.csv", "a row per " + noun, standings_csv(standings)}};
  results.table = {matchups_table(matchups), "\n", standings_table(standings)};
  results.shown = {standings_progress_table(standings, noun), matchups_progress_table(matchups)};
  results.json = std::make_shared<io::Json>(
      io::Json{{"standings", json_of(standings)}, {"groups", json_of(matchups)}});
  results.groups = std::move(matchups);
  results.standings = std::move(standings);
  return results;
}

void add_team_differences(ExperimentResults& results) {
  std::vector<std::string> teams;
  for (const Standing& standing : results.standings) teams.push_back(standing.team);
  const std::vector<TeamDifference> differences = team_differences(results.groups, teams);
  if (differences.empty()) return;
  results.files.push_back(
      {"differences.csv", "a row per two teams", team_differences_csv(differences)});
  for (auto& block : team_differences_table(differences)) results.table.push_back(std::move(block));
}

}  // namespace autoref::experiments
