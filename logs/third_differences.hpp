// The noise of positions, from third differences: the change of the change of the change from one
// frame to the next.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace autoref::logs {

// A third difference needs this many evenly spaced values. It hardly depends on an object's motion,
// and noise that is independent in each frame gives it so many times its own variance.
inline constexpr std::size_t kThirdDifferenceValues = 4;
inline constexpr double kThirdDifferenceVariance = 1 + 9 + 9 + 1;

inline constexpr double kNormalMedian = 0.6745;  // median absolute value, in standard deviations

template <typename Value>
Value third_difference(const Value& a, const Value& b, const Value& c, const Value& d) {
  return d - 3 * c + 3 * b - a;
}

// The standard deviation of the noise, from the median of absolute third differences, which a few
// jumps do not change. `differences` must not be empty.
inline double noise_in(std::vector<double> differences) {
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle / kNormalMedian / std::sqrt(kThirdDifferenceVariance);
}

}  // namespace autoref::logs
