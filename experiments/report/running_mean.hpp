// How a mean converges as pairs are played. For inspection, not for deciding when to stop.
#pragma once

#include <optional>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// Mean goal difference of the first pairs, with its Student's t confidence interval. The interval
// is nullopt for a single pair.
struct RunningMean {
  double mean = 0;
  std::optional<Interval> interval;
};

// Running means after the first pair, the first two and so on, in the order of the pair numbers.
// Pairs with a void leg are left out.
std::vector<RunningMean> running_means(const Group& group);

// Range of the goal difference for an axis. The range includes zero, every mean, and all intervals
// except those after the first few pairs, which would dwarf the rest.
Interval span_to_show(const std::vector<RunningMean>& means);

}  // namespace autoref::experiments
