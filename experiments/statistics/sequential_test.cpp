#include "experiments/statistics/sequential_test.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace autoref::experiments {
namespace {

void check_test(const SequentialTest& test) {
  assert(test.d0 != test.d1);
  assert(test.alpha > 0 && test.beta > 0 && test.alpha + test.beta < 1);
  assert(2 <= test.min_pairs && test.min_pairs <= test.max_pairs);
}

Verdict verdict_of(const SequentialTest& test, const SequentialState& state) {
  if (state.pairs < test.min_pairs) return Verdict::kGoOn;
  const double ratio = state.log_likelihood_ratio;
  if (ratio >= bound_of_d1(test)) return Verdict::kAcceptD1;
  if (ratio <= bound_of_d0(test)) return Verdict::kAcceptD0;
  return state.pairs < test.max_pairs ? Verdict::kGoOn : Verdict::kUndecided;
}

// The log-likelihood of n normal differences with this mean square from the hypothesis's mean,
// maximised over the variances from `least` on, without terms that are the same for any mean.
double log_likelihood(int n, double mean_square, double least_variance) {
  const double variance = std::max(mean_square, least_variance);
  return -n / 2.0 * (std::log(variance) + mean_square / variance);
}

}  // namespace

double least_variance_of(const SequentialTest& test) {
  return std::max(std::abs(test.d0), std::abs(test.d1));
}

double bound_of_d0(const SequentialTest& test) { return std::log(test.beta / (1 - test.alpha)); }
double bound_of_d1(const SequentialTest& test) { return std::log((1 - test.beta) / test.alpha); }

SequentialState decided_by(const SequentialTest& test, std::span<const double> pair_differences) {
  check_test(test);
  const double least_variance = least_variance_of(test);
  SequentialState state;
  double squares_from_d0 = 0;
  double squares_from_d1 = 0;
  for (const double difference : pair_differences) {
    assert(std::isfinite(difference));
    squares_from_d0 += (difference - test.d0) * (difference - test.d0);
    squares_from_d1 += (difference - test.d1) * (difference - test.d1);
    ++state.pairs;
    const auto likelihood = [&](double squares) {
      return log_likelihood(state.pairs, squares / state.pairs, least_variance);
    };
    state.log_likelihood_ratio = likelihood(squares_from_d1) - likelihood(squares_from_d0);
    state.verdict = verdict_of(test, state);
    if (state.verdict != Verdict::kGoOn) break;
  }
  return state;
}

}  // namespace autoref::experiments
