// How far the referee's confidence can be relied on: among calls of 0.9, 90 % should be right.
#pragma once

#include <array>
#include <cstddef>

#include "experiments/results/call_evaluation.hpp"

namespace autoref::judge {

// Calls of similar confidence.
struct ReliabilityBand {
  int calls = 0;
  int right = 0;
  double confidence_sum = 0;
};

class Reliability {
 public:
  // Lower ends of the bands; each ends where the next one begins, and the last at 1.
  static constexpr std::array kFrom = {0.0, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.98};

  // Verdicts without a confidence do not count.
  void add(const experiments::CallVerdict& verdict);
  void add(const Reliability& other);

  const ReliabilityBand& band(std::size_t index) const { return bands_[index]; }

 private:
  std::array<ReliabilityBand, kFrom.size()> bands_;
};

}  // namespace autoref::judge
