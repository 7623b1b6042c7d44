// What the mean of a normal sample is known to: Student, The probable error of a mean, Biometrika 6
// (1908).
#pragma once

#include <optional>
#include <span>

#include "runner/statistics/interval.hpp"

namespace autoref::runner {

// Of the mean: mean -+ t(0.975, n - 1) s / sqrt(n). For independent values; exact where they are
// normal. None for fewer than two values, and where all are the same: they say nothing about how
// far off the next one may be.
std::optional<Interval> mean_interval(std::span<const double> sample);

// The two-sided p value of the t test of "the true mean is 0": how probable a mean at least as far
// from 0 would be if that were so. None for fewer than two values, or where all are the same.
std::optional<double> p_of_zero_mean(std::span<const double> sample);

}  // namespace autoref::runner
