#include "experiments/statistics/sample.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace autoref::experiments {
namespace {

// Returns the sum of (x - mean(x)) (y - mean(y)).
double sum_of_products(std::span<const double> x, std::span<const double> y) {
  const double mean_x = mean(x);
  const double mean_y = mean(y);
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - mean_x) * (y[i] - mean_y);
  return sum;
}

}  // namespace

double mean(std::span<const double> sample) {
  assert(!sample.empty());
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

double median(std::vector<double> sample) {
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::nth_element(sample.begin(), middle, sample.end());
  return *middle;
}

std::optional<double> standard_deviation(std::span<const double> sample) {
  if (sample.size() < 2) return std::nullopt;
  return std::sqrt(sum_of_products(sample, sample) / static_cast<double>(sample.size() - 1));
}

// Ordinary least squares: covariance over variance; the factors n - 1 cancel.
std::optional<double> slope_of(std::span<const double> x, std::span<const double> y) {
  assert(x.size() == y.size());
  if (x.empty()) return std::nullopt;
  const double spread = sum_of_products(x, x);
  if (!(spread > 0)) return std::nullopt;
  return sum_of_products(x, y) / spread;
}

}  // namespace autoref::experiments
