#include "runner/statistics/bradley_terry.hpp"

#include "runner/statistics/penalised_likelihood.hpp"

namespace autoref::runner {

Eigen::VectorXd bradley_terry(std::size_t teams, std::span<const MatchupTotals> totals) {
  return PenalisedLikelihood(teams, totals).maximum().strengths;
}

}  // namespace autoref::runner
