// Inference on the mean of a normal sample: Student, The probable error of a mean, Biometrika 6
// (1908).
#pragma once

#include <optional>
#include <span>

#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {

// Student's t confidence interval of the mean: mean -+ t(0.975, n - 1) s / sqrt(n). Assumes
// independent values; exact if they are normal. Returns nullopt for fewer than two values, and if
// all values are equal, since the spread is then unknown.
std::optional<Interval> mean_interval(std::span<const double> sample);

// Two-sided p value of the t test of "the true mean is 0": the probability of a mean at least this
// far from 0 under that hypothesis. Returns nullopt for fewer than two values, or if all are equal.
std::optional<double> p_of_zero_mean(std::span<const double> sample);

}  // namespace autoref::experiments
