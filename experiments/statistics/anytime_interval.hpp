// An interval that stays valid when you look at it after every value, and a comparison that ends as
// soon as this interval decides it.
#pragma once

#include <optional>
#include <span>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sequential_test.hpp"

namespace autoref::experiments {

// A 95 % confidence sequence of the mean: in 95 % of experiments, the intervals after the second
// value, the third and so on all contain the true mean. The interval therefore remains valid if the
// values themselves decide when to stop, as in a sequential test; Student's interval does not
// remain valid.
//
// It contains the means that a mixture of t tests does not reject. With t the statistic of n values
// for a mean, nu = n - 1, and the effect size (mean over standard deviation) distributed as
// N(0, g) under the alternative, the likelihood ratio of scale-invariant data is
//
//     (1 + n g)^(-1/2) [(1 + t^2 / nu) / (1 + t^2 / (nu (1 + n g)))]^(n / 2)
//
// and a mean is rejected where this exceeds 1 / 0.05 (Lai, On confidence sequences, Ann. Stat. 4,
// 1976; Ville's inequality). Exact for normal values. About 1.3 to 1.7 times as wide as Student's
// interval.
//
// The standard deviation is taken to be at least `least_deviation`, which only widens the interval.
// Returns nullopt for fewer than two values, if all are equal and least_deviation is 0, and while
// the interval is unbounded.
std::optional<Interval> anytime_interval(std::span<const double> sample,
                                         double least_deviation = 0);

// The p value of the hypothesis that the mean is 0; it is valid at any time, like
// anytime_interval(), and below 0.05 exactly if that interval does not contain 0. It is 1 for fewer
// than two values, and if all are equal and least_deviation is 0.
double anytime_p(std::span<const double> sample, double least_deviation = 0);

// When a comparison of two teams ends. Its unit is the pair of legs, or several pairs with the same
// number against several opponents: one value of how much better the first team did, in goals per
// game.
struct ComparisonTest {
  double least = 0.3;   // goals per game; the smallest difference that matters
  int max_pairs = 300;  // the comparison ends undecided after this pair
};

// The least standard deviation that the comparison assumes, in goals: the variance is at least
// `least` (in squared goals), for the reason given at least_variance_of(). A few pairs without
// goals, or games that all end 10:0, would show no spread.
double least_deviation(const ComparisonTest& test);

struct ComparisonState {
  // kNotShown: the difference is smaller than the test's `least`.
  ThreeWayVerdict verdict = ThreeWayVerdict::kGoOn;
  int pairs = 0;                     // values considered; later ones do not count
  double mean = 0;                   // of these values
  std::optional<Interval> interval;  // of the mean, by anytime_interval()
  double p = 1;  // of a mean of 0; it may be read after every pair, like the interval
};

// The comparison ends at the first value after which the interval
//
//   - lies above or below 0: the first team is better, or worse, or
//   - lies within -least and least: there is no difference that matters.
//
// All three statements are read from one confidence sequence. If there is no difference, the
// comparison therefore says "better" or "worse" in at most 5 % of cases altogether, and if there is
// a difference of at least `least`, it says "no difference" in at most 2.5 %. These bounds hold
// however the comparison ends, and are exact for normal values; `coverage` (tools/coverage/)
// measures them for goals, along with the share of differences found.
//
// The standard deviation is taken to be at least least_deviation().
//
// p is the inverse of the likelihood ratio above for a mean of 0, at most 1. It is below 0.05
// exactly if the interval does not contain 0.
//
// No decision is possible before the tenth value, since the interval is then still unbounded.
//
// Requires that least and max_pairs are positive.
ComparisonState decided_by(const ComparisonTest& test, std::span<const double> pair_differences);

// About how many pairs would decide an undecided comparison if mean and spread stayed as they are;
// nullopt without an interval, and if more than a million pairs are needed.
std::optional<int> pairs_to_decide(const ComparisonTest& test, const ComparisonState& state);

}  // namespace autoref::experiments
