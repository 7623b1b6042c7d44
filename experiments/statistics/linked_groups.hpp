// Groups of teams that games link, and the normal equations of their ratings.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {

// The group of each of `teams` teams. Two teams are in the same group if games link them, directly
// or through other teams; only then can their ratings be compared. Groups are numbered from 0 in
// the order of their first teams. A team without games is a group by itself.
std::vector<std::size_t> linked_groups(std::size_t teams, std::span<const MatchupTotals> totals);

// The matrix that replaces each team's value by the mean of its group. Added to the normal
// equations of ratings, which are singular because a constant added to a whole group changes
// nothing, it makes them positive definite and their solution the one that sums to zero in each
// group. It leaves their determinant on the space of such ratings unchanged.
Eigen::MatrixXd group_means(const std::vector<std::size_t>& groups);

// Adds a matchup with the given weight to the normal equations: weight x x', where x is 1 for team
// a, -1 for team b and 0 for all others.
void add_to_normal_equations(Eigen::MatrixXd& equations, const MatchupTotals& matchup,
                             double weight);

}  // namespace autoref::experiments
