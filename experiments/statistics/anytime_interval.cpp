#include "experiments/statistics/anytime_interval.hpp"

#include <cmath>

#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

// Variance of the effect size under the alternative: effects of about 0.3 standard deviations, as
// of half a goal where pairs of legs vary by 1.7 goals. Any value is valid; a wrong one widens the
// interval a little.
constexpr double kEffectVariance = 0.1;

}  // namespace

std::optional<Interval> anytime_interval(std::span<const double> sample) {
  const std::optional<double> deviation = standard_deviation(sample);
  if (!deviation || !(*deviation > 0)) return std::nullopt;
  const auto n = static_cast<double>(sample.size());
  const double spread = 1 + n * kEffectVariance;
  // Solves the likelihood ratio for t^2.
  const double ratio = std::pow(std::sqrt(spread) / kMissedShare, 2 / n);
  if (ratio >= spread) return std::nullopt;
  const double t = std::sqrt((n - 1) * (ratio - 1) / (1 - ratio / spread));
  const double half = t * *deviation / std::sqrt(n);
  return Interval{mean(sample) - half, mean(sample) + half};
}

}  // namespace autoref::experiments
