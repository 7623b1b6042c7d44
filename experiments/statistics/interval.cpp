#include "experiments/statistics/interval.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
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

using boost::math::binomial_distribution;

void check_share(double successes, double n) { assert(0 <= successes && successes <= n); }

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

std::optional<Interval> wilson_interval(double successes, double n) {
  check_share(successes, n);
  if (!(n > 0)) return std::nullopt;
  const double z = quantile(complement(boost::math::normal(), kMissedShare / 2));
  const double share = successes / n;
  // Solves |share - p| = z sqrt(p (1 - p) / n) for p; the two roots are centre -+ half.
  const double shrink = 1 + z * z / n;
  const double centre = (share + z * z / (2.0 * n)) / shrink;
  const double half = z / shrink * std::sqrt(share * (1 - share) / n + z * z / (4.0 * n * n));
  // Without successes (or failures), one end is exactly 0 (or 1); avoid the rounding error.
  return Interval{successes == 0 ? 0 : centre - half, successes == n ? 1 : centre + half};
}

std::optional<Interval> clopper_pearson_interval(int successes, int n) {
  check_share(successes, n);
  if (n == 0) return std::nullopt;
  constexpr auto kExact = binomial_distribution<>::clopper_pearson_exact_interval;
  constexpr double kTail = kMissedShare / 2;
  return Interval{binomial_distribution<>::find_lower_bound_on_p(n, successes, kTail, kExact),
                  binomial_distribution<>::find_upper_bound_on_p(n, successes, kTail, kExact)};
}

std::optional<Interval> proportion_interval(int successes, int n) {
  const bool is_one_sided = successes == 0 || successes == n;
  return is_one_sided ? clopper_pearson_interval(successes, n) : wilson_interval(successes, n);
}

std::optional<Interval> f1_interval(int right, int wrong, int missed) {
  return wilson_interval(right, right + 0.5 * (wrong + missed));
}

std::optional<Interval> median_interval(std::vector<double> sample) {
  if (sample.empty()) return std::nullopt;
  // Each value is below the true median with probability 1/2. The interval misses the median on the
  // left if fewer than k values are below it.
  const boost::math::binomial below(static_cast<double>(sample.size()), 0.5);
  std::size_t k = 0;
  while (cdf(below, static_cast<double>(k)) <= kMissedShare / 2) ++k;
  if (k == 0) return std::nullopt;
  std::sort(sample.begin(), sample.end());
  return Interval{sample[k - 1], sample[sample.size() - k]};
}

}  // namespace autoref::experiments
