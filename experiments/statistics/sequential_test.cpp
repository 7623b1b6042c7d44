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

// The log-likelihood of n normal differences, given their mean squared distance from the mean of
// the hypothesis. The log-likelihood is maximised over all variances that are at least `least`, and
// omits terms that are the same for any mean.
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

std::string name_of(ThreeWayVerdict verdict, std::string_view not_shown) {
  switch (verdict) {
    case ThreeWayVerdict::kBetter:
      return "better";
    case ThreeWayVerdict::kWorse:
      return "worse";
    case ThreeWayVerdict::kNotShown:
      return std::string(not_shown);
    case ThreeWayVerdict::kUndecided:
      return "undecided";
    case ThreeWayVerdict::kGoOn:
      break;
  }
  return "none";
}

ThreeWayState compared(const SequentialTest& test, std::span<const double> pair_differences) {
  assert(test.d0 == 0 && test.d1 > 0);
  SequentialTest downwards = test;
  downwards.d1 = -test.d1;
  const SequentialState better = decided_by(test, pair_differences);
  const SequentialState worse = decided_by(downwards, pair_differences);
  const bool is_better = better.verdict == Verdict::kAcceptD1;
  const bool is_worse = worse.verdict == Verdict::kAcceptD1;
  if (is_better && (!is_worse || better.pairs <= worse.pairs)) {
    return {ThreeWayVerdict::kBetter, better.pairs};
  }
  if (is_worse) return {ThreeWayVerdict::kWorse, worse.pairs};
  const int pairs = std::max(better.pairs, worse.pairs);
  const bool is_open = better.verdict == Verdict::kGoOn || worse.verdict == Verdict::kGoOn;
  if (is_open) return {ThreeWayVerdict::kGoOn, pairs};
  const bool is_zero = better.verdict == Verdict::kAcceptD0 && worse.verdict == Verdict::kAcceptD0;
  return {is_zero ? ThreeWayVerdict::kNotShown : ThreeWayVerdict::kUndecided, pairs};
}

}  // namespace autoref::experiments
