// Sample sizes: how many games are needed to detect a difference.
#pragma once

#include <optional>

namespace autoref::experiments {

// Parameters of the two-sided one-sample t test of "the mean goal difference is 0", with the pair
// of legs as the unit. The true mean difference is `delta` goals per game, and the standard
// deviation of a single game's difference is `sd` goals. Legs are assumed independent, so a pair's
// mean has the standard deviation sd / sqrt(2). `delta` must not be 0, `sd` must be positive,
// `alpha` between 0 and 1.
struct DifferenceSought {
  double delta = 0;
  double sd = 0;
  double alpha = 0.05;  // probability of finding a difference if there is none
};

// Power of the test with this many pairs (at least two), from the noncentral t distribution.
double power_of(const DifferenceSought& sought, int pairs);

// Upper limit of the search in games_needed(); more games are impractical.
inline constexpr int kMostScheduledGames = 1'000'000;

// Minimum number of games, in pairs of two legs, for a power of at least `power` (between 0 and 1);
// nullopt if more than kMostScheduledGames are needed.
std::optional<int> games_needed(const DifferenceSought& sought, double power);

}  // namespace autoref::experiments
