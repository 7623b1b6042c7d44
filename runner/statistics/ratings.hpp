// Ratings of a round robin's teams, with what they are known to.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runner/statistics/interval.hpp"
#include "runner/statistics/rated_games.hpp"

namespace autoref::runner {

// From the number of teams and the sums of their matchups: goal_rating or bradley_terry.
using RatingMethod = std::function<Eigen::VectorXd(std::size_t, std::span<const MatchupTotals>)>;

struct Rating {
  std::string team;
  double value = 0;
  std::optional<Interval> interval;
};

// How often the games are drawn anew for the intervals.
inline constexpr int kResamples = 1000;

// With fewer pairs in a matchup there are no intervals.
inline constexpr std::size_t kFewestResampled = 5;

// A rating for each team, by name. The intervals are bootstrap percentiles (Efron, Bootstrap
// methods, Ann. Stat. 7, 1979): `kResamples` times as many pairs of legs as each matchup has are
// drawn from it, with replacement, legs staying together, and the teams are rated anew; the
// interval spans the middle 95 % of the outcomes. It is none where a matchup has fewer than
// kFewestResampled pairs or all outcomes are the same, and too narrow where matchups have few:
// among four equal teams it holds the truth in 91 % of round robins of 5 pairs a matchup, in 93 %
// of those of 10, in 94 % of those of 30 (tests/coverage/). The draws come from a fixed random
// stream and go through matchups and pairs by name, so that the order of `matchups` does not
// matter.
std::vector<Rating> ratings_of(std::vector<RatedMatchup> matchups, const RatingMethod& rate);

// The value below which `share` (0 to 1) of the sample lies, between two values by the straight
// line (Hyndman's and Fan's type 7, R's default). Not for empty samples.
double quantile_of(std::vector<double> sample, double share);

}  // namespace autoref::runner
