// Teams' strengths in goals.
#pragma once

#include <Eigen/Core>
#include <span>

#include "runner/statistics/rated_games.hpp"

namespace autoref::runner {

// A rating for each of `teams` teams, such that a game between two is expected to end with the
// difference of their ratings: least squares over all games. The ratings of teams that are linked
// by games sum to zero; between groups of teams that are not, they tell nothing. `totals` hold each
// matchup once; one without games changes nothing.
Eigen::VectorXd goal_rating(std::size_t teams, std::span<const MatchupTotals> totals);

}  // namespace autoref::runner
