// Confidence interval of F1, the harmonic mean of precision and recall.
#pragma once

#include <optional>

#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// F1 = 2 right / (2 right + wrong + missed) is treated as a proportion: of `right` successes in
// right + (wrong + missed) / 2 trials, the mean of the numbers of calls and of events. Returns
// Wilson's interval of it (proportion_interval.hpp), and nullopt if there are no trials.
//
// If every mistake makes a missed event and a wrong call at once, such as a throw-in given to the
// wrong team, the trials are the events, and the coverage is Wilson's. If missed events and wrong
// calls are independent mistakes, the variance of F1 is smaller, by half if mistakes are rare, so
// the interval is wider than necessary: its coverage exceeds 95 %. Dependence between the events of
// one game is not considered.
std::optional<Interval> f1_interval(int right, int wrong, int missed);

}  // namespace autoref::experiments
