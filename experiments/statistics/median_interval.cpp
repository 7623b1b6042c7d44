#include "experiments/statistics/median_interval.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>

namespace autoref::experiments {

std::optional<Interval> median_interval(std::vector<double> sample) {
  if (sample.empty()) return std::nullopt;
  // Each value is below the true median with probability 1/2. The interval misses it on the left if
  // fewer than k values are.
  const boost::math::binomial below(static_cast<double>(sample.size()), 0.5);
  std::size_t k = 0;
  while (cdf(below, static_cast<double>(k)) <= kMissedShare / 2) ++k;
  if (k == 0) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  return Interval{sample[k - 1], sample[sample.size() - k]};
}

}  // namespace autoref::experiments
