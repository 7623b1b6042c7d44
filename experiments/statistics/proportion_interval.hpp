// Confidence intervals of proportions, such as games won or calls that were right.
#pragma once

#include <optional>

#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// All three take `successes` (0 to n) in n independent trials with equal probability, and return
// nullopt for n = 0.

// Wilson's score interval (Wilson, Probable inference, J. Am. Stat. Assoc. 22, 1927), without
// continuity correction. Its coverage is 95 % on average over all proportions, and lower for some.
// The numbers need not be whole: n may be an effective number of trials.
std::optional<Interval> wilson_interval(double successes, double n);

// The exact interval (Clopper and Pearson, Biometrika 26, 1934). Its coverage is at least 95 % for
// every proportion, so it is wider.
std::optional<Interval> clopper_pearson_interval(int successes, int n);

// The interval to report: Wilson's, or Clopper and Pearson's if no trial or every trial succeeded.
// In those cases Wilson's is shorter and has its lowest coverage just for the proportions of most
// interest ("never", "always").
std::optional<Interval> proportion_interval(int successes, int n);

}  // namespace autoref::experiments
