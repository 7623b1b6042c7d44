#include "experiments/statistics/sample_size.hpp"

#include <algorithm>
#include <boost/math/distributions/non_central_t.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cassert>
#include <cmath>
#include <numbers>

namespace autoref::experiments {
namespace {

constexpr int kLegs = 2;
constexpr int kFewestPairs = 2;
constexpr int kMostPairsOfSample = kMostScheduledGames / kLegs;

// Two pairs suffice to detect an effect of this many standard deviations. For much larger effects,
// Boost's noncentral t distribution fails.
constexpr double kCertainEffect = 100;

double effect_of(const DifferenceSought& sought) {
  const double pair_sd = sought.sd / std::numbers::sqrt2;
  return std::min(std::abs(sought.delta) / pair_sd, kCertainEffect);
}

}  // namespace

double power_of(const DifferenceSought& sought, int pairs) {
  assert(sought.delta != 0 && sought.sd > 0 && 0 < sought.alpha && sought.alpha < 1);
  assert(pairs >= kFewestPairs);
  const double degrees_of_freedom = pairs - 1;
  // The t statistic follows the central distribution if there is no difference, and the noncentral
  // one if there is; the power is the probability of the noncentral distribution beyond either
  // critical value.
  const boost::math::students_t without(degrees_of_freedom);
  const boost::math::non_central_t with(degrees_of_freedom, effect_of(sought) * std::sqrt(pairs));
  const double bound = quantile(complement(without, sought.alpha / 2));
  return cdf(complement(with, bound)) + cdf(with, -bound);
}

// The power grows with the number of pairs. Double the number of pairs until the power is
// sufficient, then bisect.
std::optional<int> games_needed(const DifferenceSought& sought, double power) {
  assert(0 < power && power < 1);
  const auto is_enough = [&](int pairs) { return power_of(sought, pairs) >= power; };
  int too_few = kFewestPairs - 1;
  int enough = kFewestPairs;
  while (!is_enough(enough)) {
    if (enough == kMostPairsOfSample) return std::nullopt;
    too_few = enough;
    enough = std::min(2 * enough, kMostPairsOfSample);
  }
  while (enough - too_few > 1) {
    const int middle = too_few + (enough - too_few) / 2;
    (is_enough(middle) ? enough : too_few) = middle;
  }
  return kLegs * enough;
}

}  // namespace autoref::experiments
