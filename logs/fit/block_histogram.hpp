// Counts of values over a recording of any length, for quantiles with intervals.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "logs/fit/estimate.hpp"

namespace autoref::logs {

// How often values were seen in each block of time. Its memory is bounded: when there are too many
// blocks, neighbours are merged, even if they belong to different parts or logs.
class BlockHistogram {
 public:
  // Values of `highest` or more count as the highest. Values must not be negative.
  explicit BlockHistogram(double highest) : bin_width_(highest / kBins) {}

  void start_block();
  void add(double value);  // to the latest block; there must be one
  // The value below which a share `share` of all values lies; its interval is the bootstrap's over
  // blocks. Without a number if there are too few blocks, or too few values above it.
  Estimate quantile(double share) const;

 private:
  static constexpr std::size_t kBins = 500;
  static constexpr std::size_t kMostBlocks = 512;  // even, so that they can be merged in pairs
  using Counts = std::array<std::uint32_t, kBins>;

  double quantile_of(const std::array<std::uint64_t, kBins>& counts, double wanted) const;
  void merge_pairs();

  double bin_width_;
  std::vector<Counts> blocks_;
  std::int64_t starts_per_block_ = 1;
  std::int64_t starts_in_last_ = 0;
};

}  // namespace autoref::logs
