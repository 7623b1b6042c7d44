// Confidence intervals.
#pragma once

namespace autoref::experiments {

// A 95 % confidence interval. Method and assumptions are documented where it is computed. An end
// that the sample does not bound is infinite.
struct Interval {
  double low = 0;
  double high = 0;
};

// Probability that an interval misses the true value, half on either side.
inline constexpr double kMissedShare = 0.05;

}  // namespace autoref::experiments
