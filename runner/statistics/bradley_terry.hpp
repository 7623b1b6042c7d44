// Team strengths estimated from wins.
#pragma once

#include <Eigen/Core>
#include <span>

#include "runner/statistics/rated_games.hpp"

namespace autoref::runner {

// Strengths of `teams` teams such that a beats b with probability 1 / (1 + exp(strength of b -
// strength of a)): the Bradley-Terry model (Rank analysis of incomplete block designs, Biometrika
// 39, 1952), with a draw counted as half a win for each team. Strengths of teams linked by games
// sum to zero; strengths of unlinked groups of teams cannot be compared. `totals` contains each
// matchup once.
//
// The maximum-likelihood strength of a team that won all its games is infinite. One drawn game is
// therefore added to each matchup that was played: for two teams this is Firth's correction (Bias
// reduction of maximum likelihood estimates, Biometrika 80, 1993), that is, Jeffreys' prior. It
// shrinks strengths, for example that of 40 wins in 40 games to log(40.5 / 0.5) = 4.4.
//
// Uses Newton's method on the concave log-likelihood and halves steps until they improve it. Stops
// when a step changes no strength by 1e-10, after at most 100 steps. Hunter's MM algorithm (Ann.
// Stat. 32, 2004) has the same fixed point but needs more steps.
Eigen::VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals);

}  // namespace autoref::runner
