#include "experiments/report/running_mean.hpp"

#include <algorithm>

#include "experiments/statistics/mean_interval.hpp"
#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

constexpr double kMeanMargin = 0.05;   // fraction of the span, above and below
constexpr std::size_t kWildPairs = 5;  // intervals of the first pairs may leave the axis

}  // namespace

std::vector<RunningMean> running_means(const Group& group) {
  const std::vector<double> values = values_of(group.pair_differences);
  std::vector<RunningMean> means;
  for (std::size_t n = 1; n <= values.size(); ++n) {
    const std::span<const double> first(values.data(), n);
    means.push_back({mean(first), mean_interval(first)});
  }
  return means;
}

Interval span_to_show(const std::vector<RunningMean>& means) {
  Interval span;
  const auto include = [&span](double value) {
    span = {std::min(span.low, value), std::max(span.high, value)};
  };
  const std::size_t wild = std::min(kWildPairs, means.size() - 1);
  for (std::size_t i = 0; i < means.size(); ++i) {
    include(means[i].mean);
    // With few pairs Student's t is so wide that it would flatten the rest of the curve.
    if (i < wild || !means[i].interval) continue;
    include(means[i].interval->low);
    include(means[i].interval->high);
  }
  const double width = span.high > span.low ? span.high - span.low : 1;
  return {span.low - kMeanMargin * width, span.high + kMeanMargin * width};
}

}  // namespace autoref::experiments
