// Confidence intervals of Bradley-Terry strengths.
#pragma once

#include <optional>
#include <vector>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/penalised_likelihood.hpp"

namespace autoref::experiments {

// Draws are half wins, which vary less than wins and losses: 1 - (draws / 4) / (sum of n p (1 - p))
// is the variance of all games' results as a share of that without draws. `maximum` is
// likelihood.maximum(). At most 1, and at least kLeastDispersion, so that intervals do not vanish
// if almost all games are drawn.
double dispersion(const PenalisedLikelihood& likelihood, const LikelihoodPoint& maximum);

// Its value if half of the games of equal teams are drawn.
inline constexpr double kLeastDispersion = 0.5;

// For each team, the 95 % confidence interval of its strength against the mean of its group, from
// the profile of the penalised likelihood (Heinze and Schemper, A solution to the problem of
// separation in logistic regression, Stat. Med. 21, 2002). It contains the strengths for which
// twice the drop of the likelihood's logarithm, with the strengths of all other teams as likely as
// possible, is at most dispersion() times the 95 % quantile of chi-squared with one degree of
// freedom. Its ends are found by Venzon and Moolgavkar's method (A method for computing
// profile-likelihood-based confidence intervals, Appl. Stat. 37, 1988).
//
// The interval of a team that won all its games has no upper end: it is infinity, since no game
// says how much stronger the team may be. That of a team that lost all of them begins at -infinity.
// A team without games has no interval, nor has one whose ends are not found within 100 steps.
//
// `maximum` is likelihood.maximum().
std::vector<std::optional<Interval>> profile_intervals(const PenalisedLikelihood& likelihood,
                                                       const LikelihoodPoint& maximum);

}  // namespace autoref::experiments
