// What benchmarks measure: ratios of times that were taken in the same round, since machines are
// shared and their speed changes.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "experiments/statistics/interval.hpp"
#include "experiments/statistics/sample.hpp"

namespace autoref::benchmarks {

// Median of the rounds with its 95 % interval.
struct MeasuredRatio {
  double median = 1;
  experiments::Interval interval{1, 1};
};

// `values` has one value per round, at least kFewestRounds (options.hpp).
inline MeasuredRatio measured_ratio(const std::vector<double>& values) {
  return {experiments::median(values), experiments::median_interval(values).value()};
}

// "1.042 [1.003, 1.083]", times `factor`.
inline std::string text_of_ratio(const MeasuredRatio& ratio, double factor = 1) {
  return fmt::format("{:.3f} [{:.3f}, {:.3f}]", factor * ratio.median, factor * ratio.interval.low,
                     factor * ratio.interval.high);
}

}  // namespace autoref::benchmarks
