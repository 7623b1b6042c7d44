// Inference on a median without assumptions about the distribution.
#pragma once

#include <optional>
#include <vector>

#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// Interval between two order statistics, which inverts the sign test: the k-th smallest and k-th
// largest value, with the largest k that misses the true median in at most 5 % of samples (W. J.
// Conover, Practical Nonparametric Statistics, on confidence intervals of quantiles). Assumes only
// independent values; conservative. Returns nullopt for fewer than six values, which are too few
// for any k.
std::optional<Interval> median_interval(std::vector<double> sample);

}  // namespace autoref::experiments
