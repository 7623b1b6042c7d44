#include "runner/analysis/standings_report.hpp"

#include <fmt/format.h>

#include <tuple>

#include "runner/io/csv.hpp"
#include "runner/io/table.hpp"
#include "runner/statistics/mean_interval.hpp"
#include "runner/statistics/sample.hpp"

namespace autoref::runner {
namespace {

Cells results_of(const Group& matchup) {
  return {std::to_string(matchup.wins_a), std::to_string(matchup.draws),
          std::to_string(matchup.wins_b)};
}

std::string csv_of(const std::vector<Cells>& rows) {
  std::string csv;
  for (const Cells& row : rows) csv += csv_line(row) + "\n";
  return csv;
}

// The first cells of a team's row, both in standings.csv and in the text table.
Cells record_of(const Standing& standing, std::size_t rank) {
  return {std::to_string(rank),
          standing.team,
          std::to_string(standing.points()),
          std::to_string(standing.games()),
          std::to_string(standing.wins),
          std::to_string(standing.draws),
          std::to_string(standing.losses)};
}

Cells difference_cells(const Standing& standing) {
  const std::vector<double>& sample = standing.differences;
  const auto& [low, high] = bounds_of(mean_interval(standing.pair_differences));
  return {number_cell(sample.empty() ? std::nullopt : std::optional(mean(sample))),
          std::to_string(standing.pair_differences.size()), number_cell(low), number_cell(high)};
}

Cells rating_columns() {
  return {"rating_goals",  "rating_goals_low95",  "rating_goals_high95",
          "bradley_terry", "bradley_terry_low95", "bradley_terry_high95"};
}

Cells rating_cells(const Standing& standing) {
  Cells cells;
  for (const Rating* rating : {&standing.goals, &standing.strength}) {
    const auto& [low, high] = bounds_of(rating->interval);
    append(cells, {number_cell(rating->value), number_cell(low), number_cell(high)});
  }
  return cells;
}

Cells rating_texts(const Standing& standing) {
  return {mean_text(standing.goals.value, standing.goals.interval),
          mean_text(standing.strength.value, standing.strength.interval)};
}

// Drops the counts, which have their own columns further left.
Cells shares_only(const Cells& cells) {
  return {cells.begin() + std::tuple_size_v<ResultCounts>, cells.end()};
}

}  // namespace

Cells matchup_columns() {
  Cells columns = {"team_a", "team_b"};
  append(columns, summary_columns());
  append(columns, result_columns());
  return columns;
}

Cells matchup_cells(const Group& matchup) {
  Cells cells = matchup.values;
  append(cells, summary_cells(matchup));
  append(cells, share_cells(matchup.results()));
  return cells;
}

std::string matchups_csv(const std::vector<Group>& matchups) {
  std::vector<Cells> rows = {matchup_columns()};
  for (const Group& matchup : matchups) rows.push_back(matchup_cells(matchup));
  return csv_of(rows);
}

std::string standings_csv(const std::vector<Standing>& standings) {
  std::vector<Cells> rows = {{"rank", "team", "points", "games", "wins", "draws", "losses",
                              "void_games", "goals_for", "goals_against", "mean_diff", "pairs",
                              "diff_low95", "diff_high95"}};
  if (are_rated(standings)) append(rows.front(), rating_columns());
  append(rows.front(), shares_only(share_columns({"wins", "draws", "losses"})));
  for (const Standing& standing : standings) {
    Cells cells = record_of(standing, rows.size());
    append(cells, {std::to_string(standing.void_games), fmt::format("{}", standing.goals_for),
                   fmt::format("{}", standing.goals_against)});
    append(cells, difference_cells(standing));
    if (standing.is_rated) append(cells, rating_cells(standing));
    append(cells, shares_only(share_cells(standing.results())));
    rows.push_back(std::move(cells));
  }
  return csv_of(rows);
}

std::vector<Cells> matchups_rows(const std::vector<Group>& matchups) {
  std::vector<Cells> rows = {{"a", "b"}};
  append(rows.front(), table_columns());
  append(rows.front(), {"a won", "drawn", "b won"});
  for (const Group& matchup : matchups) {
    rows.push_back(matchup.values);
    append(rows.back(), table_cells(matchup));
    append(rows.back(), results_of(matchup));
  }
  return rows;
}

std::vector<Cells> standings_rows(const std::vector<Standing>& standings) {
  std::vector<Cells> rows = {{"", "team", "points", "games", "won", "drawn", "lost", "goals"}};
  append(rows.front(), are_rated(standings)
                           ? Cells{"rating in goals [95 %]", "Bradley-Terry [95 %]"}
                           : Cells{"goal difference [95 %]"});
  for (const Standing& standing : standings) {
    Cells cells = record_of(standing, rows.size());
    cells.push_back(fmt::format("{}:{}", standing.goals_for, standing.goals_against));
    append(cells, standing.is_rated
                      ? rating_texts(standing)
                      : Cells{difference_text(standing.differences, standing.pair_differences)});
    rows.push_back(std::move(cells));
  }
  return rows;
}

TextTable matchups_table(const std::vector<Group>& matchups) {
  return without_void_games({matchups_rows(matchups), kMatchupsColumns, 2});
}

TextTable standings_table(const std::vector<Standing>& standings) {
  return {standings_rows(standings), kStandingsColumns, 2};
}

}  // namespace autoref::runner
