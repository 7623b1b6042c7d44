// Descriptive statistics of a sample: mean, median, standard deviation, slope.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace autoref::experiments {

// The sample must not be empty.
double mean(std::span<const double> sample);

// The upper median if the number of values is even. The sample must not be empty.
double median(std::vector<double> sample);

// With n - 1 in the denominator. Returns nullopt for fewer than two values.
std::optional<double> standard_deviation(std::span<const double> sample);

// Slope of the least-squares line through the points (x[i], y[i]). Returns nullopt if all x are
// equal. Both samples must have the same size.
std::optional<double> slope_of(std::span<const double> x, std::span<const double> y);

}  // namespace autoref::experiments
