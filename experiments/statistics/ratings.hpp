// Ratings of a round robin's teams, with confidence intervals.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/rated_games.hpp"

namespace autoref::experiments {

struct Rating {
  std::string team;
  double value = 0;
  std::optional<Interval> interval;
};

// Number of bootstrap resamples for the intervals of ratings in goals.
inline constexpr int kResamples = 1000;

// If a matchup has fewer pairs, ratings in goals have no intervals.
inline constexpr std::size_t kFewestResampled = 5;

// A rating in goals for each team, by name: goal_rating(). The intervals are bootstrap percentiles
// (Efron, Bootstrap methods, Ann. Stat. 7, 1979): in each of kResamples resamples, every matchup's
// pairs of legs are drawn with replacement (legs stay together) and the teams rated again; the
// interval spans the middle 95 % of these ratings. It is nullopt if a matchup has fewer than
// kFewestResampled pairs or all resamples agree, and too narrow for few pairs
// (docs/explanations/statistics.md has the measured coverage). The draws come from a fixed random
// stream and visit matchups and pairs by name, so the order of `matchups` does not matter.
std::vector<Rating> goal_ratings_of(std::vector<RatedMatchup> matchups);

// A Bradley-Terry strength for each team, by name: bradley_terry(), with profile_intervals(). All
// games are taken as independent, the two legs of a pair included.
std::vector<Rating> bradley_terry_ratings_of(std::vector<RatedMatchup> matchups);

// Quantile of a sample for `share` (0 to 1), with linear interpolation between two values (type 7
// of Hyndman and Fan, the default of R). The sample must not be empty.
double quantile_of(std::vector<double> sample, double share);

}  // namespace autoref::experiments
