#include "runner/statistics/goal_rating.hpp"

#include <Eigen/QR>
#include <cmath>

namespace autoref::runner {

Eigen::VectorXd goal_rating(std::size_t teams, std::span<const MatchupTotals> totals) {
  // One equation per matchup, for its mean game, weighted like one equation per game.
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(totals.size(), teams);
  Eigen::VectorXd differences = Eigen::VectorXd::Zero(totals.size());
  for (std::size_t i = 0; i < totals.size(); ++i) {
    const MatchupTotals& matchup = totals[i];
    if (!(matchup.games > 0)) continue;
    const double weight = std::sqrt(matchup.games);
    equations(i, matchup.a) = weight;
    equations(i, matchup.b) = -weight;
    differences(i) = matchup.difference / weight;
  }
  // Solutions differ by a constant; take the minimum-norm one, whose sum is zero.
  return equations.completeOrthogonalDecomposition().solve(differences);
}

}  // namespace autoref::runner
