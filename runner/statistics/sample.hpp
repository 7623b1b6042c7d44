// What describes a sample of scores: mean, standard deviation, slope.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace autoref::runner {

// Not for empty samples.
double mean(std::span<const double> sample);

// The upper one of an even number of values. Not for empty samples.
double median(std::vector<double> sample);

// With n - 1 in the denominator. None for fewer than two values.
std::optional<double> standard_deviation(std::span<const double> sample);

// Of the straight line of least squares through the points (x[i], y[i]). None where all x are
// equal. The sizes must agree.
std::optional<double> slope_of(std::span<const double> x, std::span<const double> y);

}  // namespace autoref::runner
