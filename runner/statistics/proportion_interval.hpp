// What a share is known to: of games won, of calls that were right.
#pragma once

#include <optional>

#include "runner/statistics/interval.hpp"

namespace autoref::runner {

// All three: for `successes` (0 to n) of n independent trials of one probability; none for n = 0.

// Wilson's score interval (Wilson, Probable inference, J. Am. Stat. Assoc. 22, 1927), without
// continuity correction. Holds the true share in 95 % of experiments on average over the shares,
// for some of them in fewer.
std::optional<Interval> wilson_interval(int successes, int n);

// The exact interval (Clopper and Pearson, Biometrika 26, 1934). Holds the true share in at least
// 95 % of experiments whatever the share; wider for it.
std::optional<Interval> clopper_pearson_interval(int successes, int n);

// The one to print: Wilson's, but Clopper's and Pearson's where no trial, or every one, succeeded.
// There Wilson's reaches less far, and the share that is most wanted ("never", "always") is the one
// for which it misses most often.
std::optional<Interval> proportion_interval(int successes, int n);

}  // namespace autoref::runner
