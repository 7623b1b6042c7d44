// Statistics of scores: means, deviations, and intervals by Student's distribution.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace autoref::runner {

// Bounds that hold the true value with 95 % probability, errors being normal and independent.
struct Interval {
  double low = 0;
  double high = 0;
};

// Not for empty samples.
double mean(std::span<const double> sample);

// With n - 1 in the denominator. None for fewer than two values.
std::optional<double> standard_deviation(std::span<const double> sample);

// Of the mean: mean -+ t(0.975, n - 1) s / sqrt(n). None for fewer than two values.
std::optional<Interval> mean_interval(std::span<const double> sample);

// Of the straight line of least squares through the points (x[i], y[i]). None where all x are
// equal. The sizes must agree.
std::optional<double> slope_of(std::span<const double> x, std::span<const double> y);

}  // namespace autoref::runner
