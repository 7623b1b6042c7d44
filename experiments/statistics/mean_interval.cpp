#include "experiments/statistics/mean_interval.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

using boost::math::students_t;

// Standard error of the mean; nullopt for fewer than two values.
std::optional<double> standard_error(std::span<const double> sample) {
  const std::optional<double> deviation = standard_deviation(sample);
  if (!deviation) return std::nullopt;
  return *deviation / std::sqrt(static_cast<double>(sample.size()));
}

students_t distribution_for(std::span<const double> sample) {
  return students_t(static_cast<double>(sample.size() - 1));
}

}  // namespace

std::optional<Interval> mean_interval(std::span<const double> sample) {
  const std::optional<double> error = standard_error(sample);
  if (!error || !(*error > 0)) return std::nullopt;
  const double t = quantile(complement(distribution_for(sample), kMissedShare / 2));
  return Interval{mean(sample) - t * *error, mean(sample) + t * *error};
}

std::optional<double> p_of_zero_mean(std::span<const double> sample) {
  const std::optional<double> error = standard_error(sample);
  if (!error || !(*error > 0)) return std::nullopt;
  const double t = std::abs(mean(sample)) / *error;
  return 2 * cdf(complement(distribution_for(sample), t));
}

}  // namespace autoref::experiments
