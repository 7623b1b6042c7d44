#include "logs/fit/block_histogram.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace autoref::logs {
namespace {

constexpr std::size_t kEnoughBlocks = 6;
// A quantile counts if at least this number of values lies above it.
constexpr double kEnoughAbove = 10;
// How far the quantile is off the limit of a simulated robot that reaches it.
constexpr double kReachedError = 0.04;

}  // namespace

void BlockHistogram::start_block() {
  if (!blocks_.empty() && starts_in_last_ < starts_per_block_) {
    ++starts_in_last_;
    return;
  }
  if (blocks_.size() == kMostBlocks) merge_pairs();
  blocks_.emplace_back().fill(0);
  starts_in_last_ = 1;
}

void BlockHistogram::merge_pairs() {
  for (std::size_t i = 0; i < kMostBlocks; ++i) {
    const Counts counts = blocks_[i];
    Counts& merged = blocks_[i / 2];
    for (std::size_t bin = 0; bin < kBins; ++bin)
      merged[bin] = i % 2 == 0 ? counts[bin] : merged[bin] + counts[bin];
  }
  blocks_.resize(kMostBlocks / 2);
  starts_per_block_ *= 2;
}

void BlockHistogram::add(double value) {
  const double bin = std::min(value / bin_width_, static_cast<double>(kBins - 1));
  ++blocks_.back()[static_cast<std::size_t>(bin)];
}

double BlockHistogram::quantile_of(const std::array<std::uint64_t, kBins>& counts,
                                   double wanted) const {
  double below = 0;
  std::size_t bin = 0;
  while (bin + 1 < kBins && below + static_cast<double>(counts[bin]) < wanted)
    below += static_cast<double>(counts[bin++]);
  const double share =
      (wanted - below) / static_cast<double>(std::max<std::uint64_t>(counts[bin], 1));
  return (static_cast<double>(bin) + share) * bin_width_;
}

Estimate BlockHistogram::quantile(double share) const {
  Estimate result;
  for (const Counts& counts : blocks_)
    for (const std::uint32_t count : counts) result.episodes += count;
  const auto estimator = [&](std::span<const std::size_t> groups) -> std::optional<double> {
    std::array<std::uint64_t, kBins> sum{};
    for (const std::size_t group : groups)
      for (std::size_t bin = 0; bin < kBins; ++bin) sum[bin] += blocks_[group][bin];
    double total = 0;
    for (const std::uint64_t count : sum) total += static_cast<double>(count);
    if (total * (1 - share) < kEnoughAbove) return std::nullopt;
    return quantile_of(sum, total * share);
  };
  result.number = bootstrap_estimate(blocks_.size(), kEnoughBlocks, kReachedError, estimator);
  return result;
}

}  // namespace autoref::logs
