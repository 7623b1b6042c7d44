#include "experiments/statistics/f1_interval.hpp"

#include "experiments/statistics/proportion_interval.hpp"

namespace autoref::experiments {

std::optional<Interval> f1_interval(int right, int wrong, int missed) {
  return wilson_interval(right, right + 0.5 * (wrong + missed));
}

}  // namespace autoref::experiments
