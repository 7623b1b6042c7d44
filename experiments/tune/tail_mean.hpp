// The mean of the last half of a path.
#pragma once

#include <vector>

#include "experiments/tune/optimiser.hpp"

namespace autoref::experiments {

// Single points of a path wander with the noise of the scores; their mean does not (Polyak and
// Juditsky, Acceleration of stochastic approximation by averaging, SIAM J. Control Optim. 30,
// 1992). The first half is left out, since it depends on the start.
class TailMean {
 public:
  explicit TailMean(Point start) : sums_({Point::Zero(start.size())}), start_(std::move(start)) {}

  void add(const Point& point) { sums_.push_back(sums_.back() + point); }

  // Of the points added so far; the start if there are none.
  Point value() const {
    const std::size_t count = sums_.size() - 1;
    if (count == 0) return start_;
    const std::size_t before = count / 2;
    return (sums_[count] - sums_[before]) / static_cast<double>(count - before);
  }

 private:
  std::vector<Point> sums_;  // of the first 0, 1, 2, ... points
  Point start_;
};

}  // namespace autoref::experiments
