// The table of a round robin: from its games' rows to its matchups' and teams' results.
#pragma once

#include <string>
#include <vector>

#include "runner/analysis/groups.hpp"
#include "runner/analysis/result_shares.hpp"
#include "runner/experiments/named_teams.hpp"
#include "runner/statistics/ratings.hpp"

namespace autoref::runner {

// A group for each matchup, in their order; its values are the two teams' names.
std::vector<Group> grouped(const std::vector<Matchup>& matchups, const RowsById& rows);

// One team's results over all its matchups. Void games count only in `void_games`.
struct Standing {
  std::string team;
  int wins = 0;
  int draws = 0;
  int losses = 0;
  int void_games = 0;
  double goals_for = 0;
  double goals_against = 0;
  std::vector<double> differences;       // of each game: its goals minus the other team's
  std::vector<double> pair_differences;  // mean over the two legs, of pairs without a void leg
  bool is_rated = false;                 // whether it has the two:
  Rating goals;     // in goals a game above the average team (statistics/goal_rating.hpp)
  Rating strength;  // Bradley's and Terry's (statistics/bradley_terry.hpp)

  int games() const { return wins + draws + losses; }
  int points() const { return 3 * wins + draws; }
  ResultCounts results() const { return {wins, draws, losses}; }
};

// Best team first: by points, then by the mean of `differences`, then by name. `matchups` are those
// of grouped().
std::vector<Standing> standings_of(const std::vector<Group>& matchups);

// The same of the first teams of the matchups alone, a gauntlet's challengers. They have no
// ratings: all met the same field, so that these would only say again what the mean goal difference
// says.
std::vector<Standing> standings_of_challengers(const std::vector<Group>& matchups);

// Whether the teams have ratings: all of a table have, or none.
bool are_rated(const std::vector<Standing>& standings);

}  // namespace autoref::runner
