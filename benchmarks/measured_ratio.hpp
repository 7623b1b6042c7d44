// Results of benchmarks: ratios of times that were measured in the same round, since machines are
// shared and their speed varies.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sample.hpp"

namespace autoref::benchmarks {

// Median over the rounds with its 95 % interval.
struct MeasuredRatio {
  double median = 1;
  experiments::Interval interval{1, 1};
};

// `values` has one value per round, at least kFewestRounds (options.hpp).
inline MeasuredRatio measured_ratio(const std::vector<double>& values) {
  return {experiments::median(values), experiments::median_interval(values).value()};
}

// `ratio` times `factor`, such as "1.042 [1.003, 1.083]".
inline std::string text_of_ratio(const MeasuredRatio& ratio, double factor = 1) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", factor * ratio.median, factor * ratio.interval.low,
                     factor * ratio.interval.high);
}

}  // namespace autoref::benchmarks
