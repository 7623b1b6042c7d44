// Descriptive statistics of a sample: mean, median, standard deviation, slope.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace autoref::experiments {

// The mean of a sample, which must not be empty.
double mean(std::span<const double> sample);

// The median of a sample, which must not be empty. If the number of values is even, it is the upper
// median.
double median(std::vector<double> sample);

// The standard deviation, with n - 1 in the denominator. Returns nullopt for fewer than two values.
std::optional<double> standard_deviation(std::span<const double> sample);

// Slope of the least-squares line through the points (x[i], y[i]). Returns nullopt if all x are
// equal. Both samples must have the same size.
std::optional<double> slope_of(std::span<const double> x, std::span<const double> y);

}  // namespace autoref::experiments
