// Ratings of a round robin's teams, with confidence intervals.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/penalised_likelihood.hpp"
#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {

// The factor that scales the intervals of Bradley-Terry strengths. Draws count as half wins, which
// vary less than wins and losses. 1 - (draws / 4) / (sum of n p (1 - p)) is the variance of the
// results of all games relative to the variance without draws. `maximum` is likelihood.maximum().
// At most 1, and at least kLeastDispersion, so that intervals do not vanish if almost all games are
// drawn.
double dispersion(const PenalisedLikelihood& likelihood, const LikelihoodPoint& maximum);

// The value of dispersion() if equal teams draw half of their games.
inline constexpr double kLeastDispersion = 0.5;

// For each team, the 95 % confidence interval of its strength against the mean of its group, from
// the profile of the penalised likelihood (Heinze and Schemper, A solution to the problem of
// separation in logistic regression, Stat. Med. 21, 2002). The interval contains the strengths for
// which twice the drop of the log-likelihood is at most dispersion() times the 95 % quantile of
// chi-squared with one degree of freedom. For each strength of the team, the strengths of all other
// teams are those of maximum likelihood. The interval's ends are found by Venzon and Moolgavkar's
// method (A method for computing profile-likelihood-based confidence intervals, Appl. Stat. 37,
// 1988).
//
// For a team that won all its games, the upper bound is infinity, since no game shows how much
// stronger the team may be. For a team that lost all its games, the lower bound is -infinity. A
// team has no interval if it has no games or if the bounds are not found within 100 steps.
//
// `maximum` is likelihood.maximum().
std::vector<std::optional<Interval>> profile_intervals(const PenalisedLikelihood& likelihood,
                                                       const LikelihoodPoint& maximum);

struct Rating {
  std::string team;
  double value = 0;
  std::optional<Interval> interval;
};

// Number of bootstrap resamples for the intervals of ratings in goals.
inline constexpr int kResamples = 1000;

// If a matchup has fewer pairs than this, ratings in goals have no intervals.
inline constexpr std::size_t kFewestResampled = 5;

// A rating in goals for each team, by name: goal_rating(). The intervals are bootstrap percentiles
// (Efron, Bootstrap methods, Ann. Stat. 7, 1979): in each of kResamples resamples, every matchup's
// pairs of legs are drawn with replacement (the legs of a pair stay together), and the teams are
// rated again. The interval spans the middle 95 % of these ratings. An interval is nullopt if a
// matchup has fewer than kFewestResampled pairs or if all resamples agree. Intervals are too narrow
// if there are few pairs (docs/explanations/statistics.md has the measured coverage). The draws
// come from a fixed random stream and visit matchups and pairs by name, so the order of `matchups`
// does not matter.
std::vector<Rating> goal_ratings_of(std::vector<RatedMatchup> matchups);

// A Bradley-Terry strength for each team, by name: bradley_terry(), with profile_intervals(). All
// games are assumed to be independent, including the two legs of a pair.
std::vector<Rating> bradley_terry_ratings_of(std::vector<RatedMatchup> matchups);

// Quantile of a sample for `share` (0 to 1), with linear interpolation between two values (type 7
// of Hyndman and Fan, the default of R). The sample must not be empty.
double quantile_of(std::vector<double> sample, double share);

}  // namespace autoref::experiments
