// Results of a round robin by matchup and by team, computed from its rows: as data, CSV files, JSON
// and text tables.
#pragma once

#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "experiments/statistics/ratings.hpp"
#include "io/json.hpp"
#include "io/table.hpp"
#include "io/table_columns.hpp"

namespace autoref::experiments {

// One group per matchup, in the order of `matchups`. A group's values are the two teams' names.
std::vector<Group> grouped(const std::vector<Matchup>& matchups, const RowsById& rows);

inline constexpr int kPointsOfWin = 3;  // a draw gives one point

// One team's results over all its matchups. Void games count only in `void_games`.
struct Standing {
  int rank = 0;  // 1 is the best
  std::string team;
  int wins = 0;
  int draws = 0;
  int losses = 0;
  int void_games = 0;
  int bye_points = 0;  // points for byes in a Swiss tournament
  int goals_for = 0;
  int goals_against = 0;
  std::vector<double> differences;  // goals for minus goals against, for each game
  // Mean goal difference over the two legs of each pair, without pairs that have a void leg.
  std::vector<double> pair_differences;
  bool is_rated = false;  // whether the ratings `goals` and `strength` are valid
  Rating goals;           // rating in goals per game above the average team
                          // (experiments/statistics/penalised_likelihood.hpp)
  Rating strength;        // Bradley-Terry (experiments/statistics/penalised_likelihood.hpp)

  int games() const { return wins + draws + losses; }
  int points() const { return kPointsOfWin * wins + draws + bye_points; }
  int pairs() const { return static_cast<int>(pair_differences.size()); }
  ResultCounts results() const { return {wins, draws, losses}; }
};

// Best team first: by points, then by mean goal difference, then by name. `matchups` come from
// grouped().
std::vector<Standing> standings_of(const std::vector<Group>& matchups);

// The standings of only the first team of each matchup: a gauntlet's challengers. Challengers are
// not rated: all of them played the same opponents, so ratings would add nothing to the mean goal
// difference.
std::vector<Standing> standings_of_challengers(const std::vector<Group>& matchups);

// Whether the teams have ratings; either all of them have one or none does.
bool are_rated(const std::vector<Standing>& standings);

// A matchup's columns: its teams, summary_columns(), then team a's wins, draws and losses with
// their fractions.
io::TableColumns<Group> matchup_columns();

// summary.csv: one row per matchup.
std::string matchups_csv(const std::vector<Group>& matchups);

// standings.csv: one row per team, best first, with games, goals, points (3 for a win, 1 for a
// draw) and the goal difference per game with its 95 % interval over all pairs. Both ratings with
// their intervals follow (-inf or inf for an open end), then the fractions of wins, draws and
// losses. Missing values are empty cells.
std::string standings_csv(const std::vector<Standing>& standings);

// [{"team": "cobalt", "points": 20, "games": 8, "wins": 6, "draws": 2, "losses": 0,
//   "goals_for": 18, "goals_against": 0}, ...], best team first, with values from the columns of
//   standings.csv.
io::Json json_of(const std::vector<Standing>& standings);

// The rows of the text tables; the first row is the header.
std::vector<io::Cells> matchups_rows(const std::vector<Group>& matchups);
std::vector<io::Cells> standings_rows(const std::vector<Standing>& standings);

// Headers of the last columns of standings_rows(): both ratings, or the goal difference if the
// teams are not rated.
inline constexpr const char* kGoalRatingHead = "rating in goals [95 %]";
inline constexpr const char* kStrengthHead = "Bradley-Terry [95 %]";
inline constexpr const char* kGoalDifferenceHead = "goal difference [95 %]";

// Alignment of the columns of matchups_rows() and standings_rows().
inline const std::vector<io::Align> kMatchupsColumns = {io::Align::kLeft, io::Align::kLeft};
inline const std::vector<io::Align> kStandingsColumns = {io::Align::kRight, io::Align::kLeft};

// The matchups and the standings as lines of text.
io::TextTable matchups_table(const std::vector<Group>& matchups);
io::TextTable standings_table(const std::vector<Standing>& standings);

}  // namespace autoref::experiments
