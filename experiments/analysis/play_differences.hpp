// What the new team of a comparison does differently: how often it does what rows count, whether or
// not that makes a difference in goals.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/team_games.hpp"
#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// Means per game, over all opponents. In games against each other, both teams' numbers are of the
// same games, so they also depend on what the other team does.
struct PlayDifference {
  std::string name;  // "chains from corner kicks"
  double of_new = 0;
  double of_old = 0;
  double mean = 0;                   // of_new - of_old
  std::optional<Interval> interval;  // anytime_interval() over pair numbers
  double p = 1;                      // anytime_p() of a mean of 0
  double p_holm = 1;                 // with Holm's correction over all of them
};

// The possession chains of each start, then the other counts of PlayCounts that are not parts of
// the goal difference (difference_parts.hpp). Every game of these pair numbers must have a row, and
// none of them may be void.
std::vector<PlayDifference> play_differences(const std::vector<PairedOpponent>& opponents,
                                             const std::vector<int>& pairs, const RowsById& rows);

// Those that are certain (p_holm at most kSignificant), the most certain one first.
std::vector<PlayDifference> certain_differences(const std::vector<PlayDifference>& differences);

}  // namespace autoref::experiments
