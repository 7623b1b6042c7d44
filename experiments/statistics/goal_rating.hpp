// Team strengths estimated from goal differences.
#pragma once

#include <Eigen/Core>
#include <span>

#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {

// Ratings of `teams` teams such that the expected goal difference of a game is the difference of
// the two ratings: least squares over all games. Ratings of teams linked by games sum to zero;
// ratings of unlinked groups of teams cannot be compared. `totals` contains each matchup once; a
// matchup without games has no effect.
Eigen::VectorXd goal_rating(std::size_t teams, std::span<const MatchupTotals> totals);

}  // namespace autoref::experiments
