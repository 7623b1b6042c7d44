// Results of a round robin by matchup and by team, computed from its rows.
#pragma once

#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/analysis/result_shares.hpp"
#include "experiments/schedule/named_teams.hpp"
#include "experiments/statistics/ratings.hpp"

namespace autoref::experiments {

// One group per matchup, in the same order. A group's values are the two teams' names.
std::vector<Group> grouped(const std::vector<Matchup>& matchups, const RowsById& rows);

inline constexpr int kPointsOfWin = 3;  // a draw gives one

// One team's results over all its matchups. Void games count only in `void_games`.
struct Standing {
  int rank = 0;  // 1 is the best
  std::string team;
  int wins = 0;
  int draws = 0;
  int losses = 0;
  int void_games = 0;
  int bye_points = 0;  // for rounds of a Swiss tournament without an opponent
  int goals_for = 0;
  int goals_against = 0;
  std::vector<double> differences;       // per game: goals for minus goals against
  std::vector<double> pair_differences;  // mean over the two legs; no pairs with a void leg
  bool is_rated = false;                 // whether the two ratings are valid
  Rating
      goals;  // in goals per game above the average team (experiments/statistics/goal_rating.hpp)
  Rating strength;  // Bradley-Terry (experiments/statistics/bradley_terry.hpp)

  int games() const { return wins + draws + losses; }
  int points() const { return kPointsOfWin * wins + draws + bye_points; }
  int pairs() const { return static_cast<int>(pair_differences.size()); }
  ResultCounts results() const { return {wins, draws, losses}; }
};

// Best team first: by points, then by the mean of `differences`, then by name. `matchups` come from
// grouped().
std::vector<Standing> standings_of(const std::vector<Group>& matchups);

// The same, but only for the first team of each matchup: a gauntlet's challengers. These are not
// rated: all of them met the same opponents, so ratings would add nothing to the mean goal
// difference.
std::vector<Standing> standings_of_challengers(const std::vector<Group>& matchups);

// Whether the teams have ratings; either all of them do or none.
bool are_rated(const std::vector<Standing>& standings);

}  // namespace autoref::experiments
