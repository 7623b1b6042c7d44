// How a mean settles as pairs are played. To look at, not to stop by.
#pragma once

#include <optional>
#include <vector>

#include "runner/analysis/groups.hpp"
#include "runner/statistics/interval.hpp"

namespace autoref::runner {

// Of the first pairs: their mean goal difference and Student's interval of it, none of one pair.
struct RunningMean {
  double mean = 0;
  std::optional<Interval> interval;
};

// After the first pair, the first two and so on, in the order of their numbers. Pairs with a void
// leg are left out.
std::vector<RunningMean> running_means(const Group& group);

// The goals that an axis should span: zero, every mean, and the intervals but for those of the
// first pairs, which would dwarf the rest.
Interval span_to_show(const std::vector<RunningMean>& means);

}  // namespace autoref::runner
