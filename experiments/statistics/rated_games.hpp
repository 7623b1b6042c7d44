// Games between several teams, as input of the ratings, and the groups of teams that they link.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace autoref::experiments {

struct RatedGame {
  double difference = 0;  // goals of team a minus goals of team b
  double win = 0;         // 1 if a won, 1/2 for a draw, 0 if b won
};

// All valid games between two teams, by pair number: one or two legs each.
struct RatedMatchup {
  std::string team_a;
  std::string team_b;
  std::map<int, std::vector<RatedGame>> pairs;
};

// Sums over the games of two teams, which are numbered from 0.
struct MatchupTotals {
  std::size_t a = 0;
  std::size_t b = 0;
  double games = 0;
  double difference = 0;
  double wins = 0;   // a's wins, draws counting one half
  double draws = 0;  // drawn games
};

// The group of each of `teams` teams. Two teams are in the same group if games link them, directly
// or through other teams; only then can their ratings be compared. Groups are numbered from 0 in
// the order of their first teams. A team without games is a group by itself.
std::vector<std::size_t> linked_groups(std::size_t teams, std::span<const MatchupTotals> totals);

// The matrix that replaces each team's value by the mean of its group. The normal equations of
// ratings are singular, because adding a constant to a whole group changes nothing. Adding this
// matrix makes them positive definite, and their solution sums to zero in each group. It leaves
// their determinant on the space of such ratings unchanged.
Eigen::MatrixXd group_means(const std::vector<std::size_t>& groups);

// Adds a matchup with the given weight to the normal equations: weight x x', where x is 1 for team
// a, -1 for team b and 0 for all others.
void add_to_normal_equations(Eigen::MatrixXd& equations, const MatchupTotals& matchup,
                             double weight);

}  // namespace autoref::experiments
