// Teams' strengths in games won.
#pragma once

#include <Eigen/Core>
#include <span>

#include "runner/statistics/rated_games.hpp"

namespace autoref::runner {

// A strength for each of `teams` teams, such that a beats b with probability
// 1 / (1 + exp(strength of b - strength of a)): Bradley's and Terry's model (Rank analysis of
// incomplete block designs, Biometrika 39, 1952), a draw counting as half a win for each. The
// strengths of teams that are linked by games sum to zero; between groups of teams that are not,
// they tell nothing. `totals` hold each matchup once.
//
// The most likely strength of a team that won all its games is infinite. So each matchup that was
// played counts as if one drawn game more had been: between two teams that is Firth's correction
// (Bias reduction of maximum likelihood estimates, Biometrika 80, 1993), which is Jeffreys' prior.
// It draws strengths together, 40 wins of 40 games to log(40.5 / 0.5) = 4.4.
//
// Newton's iteration on the concave likelihood, with steps halved until they improve it; it stops
// where a step changes no strength by 1e-10, after 100 steps at most. Hunter's MM algorithm (Ann.
// Stat. 32, 2004) has the same fixed point, in more steps.
Eigen::VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals);

}  // namespace autoref::runner
