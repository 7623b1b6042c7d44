#include "experiments/statistics/bradley_terry.hpp"

#include "experiments/statistics/penalised_likelihood.hpp"

namespace autoref::experiments {

Eigen::VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals) {
  return PenalisedLikelihood(teams, totals).maximum().strengths;
}

}  // namespace autoref::experiments
