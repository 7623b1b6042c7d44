// Team strengths estimated from wins.
#pragma once

#include <Eigen/Core>
#include <span>

#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {

// Strengths of `teams` teams such that a beats b with probability 1 / (1 + exp(strength of b -
// strength of a)), where the likelihood with Firth's penalty is largest (see PenalisedLikelihood).
// A draw counts as half a win for each team. Strengths of teams linked by games sum to zero;
// strengths of unlinked groups of teams cannot be compared. `totals` contains each matchup once.
//
// The strength of a team that won all its games would be infinite without the penalty, which
// shrinks it: for two teams, half a win is added to each, and 40 wins in 40 games give a difference
// of log(40.5 / 0.5) = 4.4.
Eigen::VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals);

}  // namespace autoref::experiments
