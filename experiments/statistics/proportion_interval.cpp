#include "experiments/statistics/proportion_interval.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cassert>
#include <cmath>

namespace autoref::experiments {
namespace {

using boost::math::binomial_distribution;

void check_share(double successes, double n) { assert(0 <= successes && successes <= n); }

}  // namespace

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

}  // namespace autoref::experiments
