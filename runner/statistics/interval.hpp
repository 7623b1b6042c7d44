// What an estimate is known to.
#pragma once

namespace autoref::runner {

// Bounds made by a rule that holds the true value in 95 % of experiments. Which rule, and what it
// takes for granted, is said where it is made.
struct Interval {
  double low = 0;
  double high = 0;
};

// The share of experiments in which an interval may miss, half on either side.
inline constexpr double kMissedShare = 0.05;

}  // namespace autoref::runner
