// How many games it takes to see a difference.
#pragma once

#include <optional>

namespace autoref::runner {

// A question to the two-sided one-sample t test of "the mean goal difference is 0", whose unit is
// the pair of legs: would it notice a mean difference of `delta` goals a game, games having the
// standard deviation `sd` in goals? Legs are taken as independent, so that a pair's mean has the
// standard deviation sd / sqrt(2). `delta` is not 0, `sd` positive, `alpha` between 0 and 1.
struct DifferenceSought {
  double delta = 0;
  double sd = 0;
  double alpha = 0.05;  // how often the test may see a difference where there is none
};

// How probably it notices with so many pairs, two at least: by Student's noncentral distribution.
double power_of(const DifferenceSought& sought, int pairs);

// More games than this nobody plays.
inline constexpr int kMostScheduledGames = 1'000'000;

// The least number of games, all in pairs of two legs, with which it notices with probability
// `power` (between 0 and 1) at least; none where that is more than kMostScheduledGames.
std::optional<int> games_needed(const DifferenceSought& sought, double power);

}  // namespace autoref::runner
