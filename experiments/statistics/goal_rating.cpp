#include "experiments/statistics/goal_rating.hpp"

#include <Eigen/Cholesky>

#include "experiments/statistics/linked_groups.hpp"

namespace autoref::experiments {

Eigen::VectorXd goal_rating(std::size_t teams, std::span<const MatchupTotals> totals) {
  Eigen::MatrixXd equations = group_means(linked_groups(teams, totals));
  Eigen::VectorXd differences = Eigen::VectorXd::Zero(teams);
  for (const MatchupTotals& matchup : totals) {
    if (!(matchup.games > 0)) continue;
    add_to_normal_equations(equations, matchup, matchup.games);
    differences(matchup.a) += matchup.difference;
    differences(matchup.b) -= matchup.difference;
  }
  return equations.llt().solve(differences);
}

}  // namespace autoref::experiments
