// A round robin's results as CSV files, as JSON and as text tables.
#pragma once

#include <string>
#include <vector>

#include "experiments/analysis/standings.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {

// A matchup's columns: its teams, summary_columns(), then team a's wins, draws and losses with
// their fractions.
io::TableColumns<Group> matchup_columns();

// summary.csv: one row per matchup.
std::string matchups_csv(const std::vector<Group>& matchups);

// standings.csv: one row per team, best first, with games, goals, points (3 for a win, 1 for a
// draw), goal difference per game with its 95 % interval over all pairs, both ratings with
// intervals (-inf or inf for an open end), and the fractions of wins, draws and losses. Missing
// values are empty cells.
std::string standings_csv(const std::vector<Standing>& standings);

// [{"team": "cobalt", "points": 20, "games": 8, "wins": 6, "draws": 2, "losses": 0,
//   "goals_for": 18, "goals_against": 0}, ...], best team first, with columns of standings.csv.
io::Json json_of(const std::vector<Standing>& standings);

// The text tables; the first row is the header.
std::vector<io::Cells> matchups_rows(const std::vector<Group>& matchups);
std::vector<io::Cells> standings_rows(const std::vector<Standing>& standings);

// Heads of the last columns of standings_rows(): both ratings, or the difference if the teams are
// not rated.
inline constexpr const char* kGoalRatingHead = "rating in goals [95 %]";
inline constexpr const char* kStrengthHead = "Bradley-Terry [95 %]";
inline constexpr const char* kGoalDifferenceHead = "goal difference [95 %]";

// Alignment of their columns.
inline const std::vector<io::Align> kMatchupsColumns = {io::Align::kLeft, io::Align::kLeft};
inline const std::vector<io::Align> kStandingsColumns = {io::Align::kRight, io::Align::kLeft};

// The same as lines of text.
io::TextTable matchups_table(const std::vector<Group>& matchups);
io::TextTable standings_table(const std::vector<Standing>& standings);

}  // namespace autoref::experiments
