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

// The straight line of least squares.
struct Line {
  double slope = 0;
  double intercept = 0;
  std::optional<Interval> slope_interval;  // t with n - 2; none for fewer than three points
};

// The line through the points (x[i], y[i]). None where all x are equal. The sizes must agree.
std::optional<Line> fit_line(std::span<const double> x, std::span<const double> y);

}  // namespace autoref::runner
