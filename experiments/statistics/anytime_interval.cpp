#include "experiments/statistics/anytime_interval.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

// Variance of the effect size under the alternative: effects of about 0.3 standard deviations, such
// as half a goal if the standard deviation over pairs of legs is 1.7 goals. The interval is valid
// for any value; a poor choice widens it a little.
constexpr double kEffectVariance = 0.1;

// More pairs than this are not worth an estimate.
constexpr int kMostPairsEstimated = 1'000'000;

// Half the width of the interval of n values; nullopt while it is unbounded.
std::optional<double> half_width(double n, double deviation) {
  const double spread = 1 + n * kEffectVariance;
  // Solves the likelihood ratio for t^2.
  const double ratio = std::pow(std::sqrt(spread) / kMissedShare, 2 / n);
  if (ratio >= spread) return std::nullopt;
  const double t = std::sqrt((n - 1) * (ratio - 1) / (1 - ratio / spread));
  return t * deviation / std::sqrt(n);
}

double p_of_zero(double n, double mean, double deviation) {
  const double square = mean * mean * n / (deviation * deviation) / (n - 1);
  const double spread = 1 + n * kEffectVariance;
  const double log_ratio =
      (n * std::log((1 + square) / (1 + square / spread)) - std::log(spread)) / 2;
  return std::min(1.0, std::exp(-log_ratio));
}

// Mean and variance, value by value (Welford, Note on a method for calculating corrected sums of
// squares and products, Technometrics 4, 1962). The mean is the same as that of mean().
struct RunningSample {
  double n = 0;
  double sum = 0;
  double squares = 0;  // sum of squared distances from the mean

  double mean() const { return sum / n; }
  double variance() const { return squares / (n - 1); }

  void add(double value) {
    const double distance = n > 0 ? value - mean() : 0;
    ++n;
    sum += value;
    squares += distance * (value - mean());
  }
};

ThreeWayVerdict verdict_of(const ComparisonTest& test, const ComparisonState& state) {
  if (state.interval) {
    if (state.interval->low > 0) return ThreeWayVerdict::kBetter;
    if (state.interval->high < 0) return ThreeWayVerdict::kWorse;
    const bool is_small = state.interval->low > -test.least && state.interval->high < test.least;
    if (is_small) return ThreeWayVerdict::kNotShown;
  }
  return state.pairs < test.max_pairs ? ThreeWayVerdict::kGoOn : ThreeWayVerdict::kUndecided;
}

}  // namespace

std::optional<Interval> anytime_interval(std::span<const double> sample, double least_deviation) {
  const std::optional<double> deviation = standard_deviation(sample);
  if (!deviation || !(std::max(*deviation, least_deviation) > 0)) return std::nullopt;
  const std::optional<double> half =
      half_width(static_cast<double>(sample.size()), std::max(*deviation, least_deviation));
  if (!half) return std::nullopt;
  return Interval{mean(sample) - *half, mean(sample) + *half};
}

double anytime_p(std::span<const double> sample, double least_deviation) {
  const std::optional<double> deviation = standard_deviation(sample);
  if (!deviation || !(std::max(*deviation, least_deviation) > 0)) return 1;
  return p_of_zero(static_cast<double>(sample.size()), mean(sample),
                   std::max(*deviation, least_deviation));
}

double least_deviation(const ComparisonTest& test) { return std::sqrt(test.least); }

ComparisonState decided_by(const ComparisonTest& test, std::span<const double> pair_differences) {
  assert(test.least > 0 && test.max_pairs > 0);
  ComparisonState state;
  RunningSample sample;
  for (const double difference : pair_differences) {
    assert(std::isfinite(difference));
    sample.add(difference);
    ++state.pairs;
    state.mean = sample.mean();
    if (state.pairs > 1) {
      const double deviation = std::max(std::sqrt(sample.variance()), least_deviation(test));
      const std::optional<double> half = half_width(sample.n, deviation);
      if (half) state.interval = Interval{state.mean - *half, state.mean + *half};
      state.p = p_of_zero(sample.n, state.mean, deviation);
    }
    state.verdict = verdict_of(test, state);
    if (state.verdict != ThreeWayVerdict::kGoOn) break;
  }
  return state;
}

std::optional<int> pairs_to_decide(const ComparisonTest& test, const ComparisonState& state) {
  if (!state.interval) return std::nullopt;
  const double half = (state.interval->high - state.interval->low) / 2;
  const double deviation = half / half_width(state.pairs, 1).value();
  const double needed = std::max(std::abs(state.mean), test.least - std::abs(state.mean));
  int too_few = state.pairs;
  int enough = kMostPairsEstimated;
  if (half_width(enough, deviation).value() > needed) return std::nullopt;
  while (enough - too_few > 1) {
    const int middle = too_few + (enough - too_few) / 2;
    (half_width(middle, deviation).value() > needed ? too_few : enough) = middle;
  }
  return enough;
}

}  // namespace autoref::experiments
