// Confidence intervals of means, medians, proportions and F1 scores.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace autoref::experiments {

// A 95 % confidence interval. The method and its assumptions are documented at each function that
// computes an interval. A bound that the sample does not determine is infinite.
struct Interval {
  double low = 0;
  double high = 0;
};

// Probability that an interval misses the true value: half of it on each side.
inline constexpr double kMissedShare = 0.05;

// Student's t confidence interval of the mean: mean -+ t(0.975, n - 1) s / sqrt(n). Assumes
// independent values; exact if they are normal. Returns nullopt for fewer than two values, and if
// all values are equal, since their spread is then unknown.
std::optional<Interval> mean_interval(std::span<const double> sample);

// Two-sided p value of the t test of "the true mean is 0": the probability of a mean at least this
// far from 0 under that hypothesis. Returns nullopt for fewer than two values, or if all are equal.
std::optional<double> p_of_zero_mean(std::span<const double> sample);

// The three intervals of a proportion take `successes` (0 to n) in n independent trials with equal
// probability, and return nullopt for n = 0.

// Wilson's score interval (Wilson, Probable inference, J. Am. Stat. Assoc. 22, 1927), without
// continuity correction. Its coverage is 95 % on average over all proportions, and lower for some.
// `successes` and `n` need not be whole: n may be an effective number of trials.
std::optional<Interval> wilson_interval(double successes, double n);

// The exact interval (Clopper and Pearson, Biometrika 26, 1934). Its coverage is at least 95 % for
// every proportion, so the interval is wider than Wilson's.
std::optional<Interval> clopper_pearson_interval(int successes, int n);

// The interval to report: Wilson's, or Clopper and Pearson's if no trial or every trial succeeded.
// In these two cases, Wilson's interval is shorter, but its coverage is lowest for the proportions
// of most interest: those near 0 and 1.
std::optional<Interval> proportion_interval(int successes, int n);

// F1 = 2 right / (2 right + wrong + missed) is treated as a proportion: `right` successes in right
// + (wrong + missed) / 2 trials, which is the mean of the numbers of calls and events. Returns its
// Wilson interval, or nullopt if there are no trials.
//
// If every mistake is both a missed event and a wrong call, such as a throw-in given to the wrong
// team, the trials are the events, and the coverage is Wilson's. If missed events and wrong calls
// are independent mistakes, the variance of F1 is smaller, by half if mistakes are rare, so the
// interval is wider than necessary: its coverage exceeds 95 %. Dependence between the events of one
// game is not considered.
std::optional<Interval> f1_interval(int right, int wrong, int missed);

// Interval between two order statistics, which inverts the sign test: the k-th smallest and k-th
// largest value, with the largest k that misses the true median in at most 5 % of samples (W. J.
// Conover, Practical Nonparametric Statistics, on confidence intervals of quantiles). Assumes only
// that the values are independent; conservative. Returns nullopt for fewer than six values, since
// no k exists for them.
std::optional<Interval> median_interval(std::vector<double> sample);

}  // namespace autoref::experiments
