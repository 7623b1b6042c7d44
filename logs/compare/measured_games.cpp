#include "logs/compare/measured_games.hpp"

#include <algorithm>
#include <cmath>

namespace autoref::logs {
namespace {

std::size_t bin_count(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::kDistribution:
      return MeasureCounts::kBins;
    case MeasureKind::kShare:
      return 2;
    case MeasureKind::kRate:
      return 1;
  }
  return 1;
}

}  // namespace

void MeasureCounts::add(const MeasureEntry& entry, double value) {
  bins_.resize(bin_count(entry.kind));
  const auto bins = static_cast<double>(bins_.size());
  const double bin = std::clamp(value / entry.highest * bins, 0.0, bins - 1);
  ++bins_[static_cast<std::size_t>(bin)];
  ++values_;
}

void MeasureCounts::add(const MeasureCounts& other) {
  bins_.resize(std::max(bins_.size(), other.bins_.size()));
  for (std::size_t i = 0; i < other.bins_.size(); ++i) bins_[i] += other.bins_[i];
  values_ += other.values_;
  duration_s_ += other.duration_s_;
}

void MeasureCounts::subtract(const MeasureCounts& other) {
  for (std::size_t i = 0; i < other.bins_.size(); ++i) bins_[i] -= other.bins_[i];
  values_ -= other.values_;
  duration_s_ -= other.duration_s_;
}

AllCounts operator+(AllCounts sum, const AllCounts& other) {
  for (std::size_t i = 0; i < kMeasureCount; ++i) sum[i].add(other[i]);
  return sum;
}

AllCounts operator-(AllCounts difference, const AllCounts& other) {
  for (std::size_t i = 0; i < kMeasureCount; ++i) difference[i].subtract(other[i]);
  return difference;
}

AllCounts& MeasuredGames::block_at(int log, double time_s) {
  const auto number = static_cast<std::int64_t>(std::floor(time_s / block_s_));
  const auto found = blocks_.find({log, number});
  if (found != blocks_.end()) return found->second;
  AllCounts& block = blocks_[{log, number}];
  if (blocks_.size() <= most_blocks_) return block;
  merge_neighbours();
  return blocks_[{log, static_cast<std::int64_t>(std::floor(time_s / block_s_))}];
}

void MeasuredGames::merge_neighbours() {
  std::map<std::pair<int, std::int64_t>, AllCounts> merged;
  for (auto& [key, block] : blocks_) {
    const auto& [log, number] = key;
    const std::int64_t half = number >= 0 ? number / 2 : (number - 1) / 2;
    AllCounts& into = merged[{log, half}];
    into = std::move(into) + block;
  }
  blocks_ = std::move(merged);
  block_s_ *= 2;
  most_blocks_ = std::max(most_blocks_, 2 * blocks_.size());
}

void MeasuredGames::add(int log, Measure measure, double time_s, double value) {
  if (!std::isfinite(time_s) || !std::isfinite(value)) return;
  block_at(log, time_s)[static_cast<std::size_t>(measure)].add(entry_of(measure), value);
}

void MeasuredGames::add_time(int log, Measure measure, double time_s, double duration_s) {
  if (!std::isfinite(time_s)) return;
  block_at(log, time_s)[static_cast<std::size_t>(measure)].add_time(duration_s);
}

void MeasuredGames::discard(int log, Measure measure) {
  for (auto& [key, block] : blocks_)
    if (key.first == log) block[static_cast<std::size_t>(measure)] = {};
}

std::vector<AllCounts> MeasuredGames::blocks() const {
  std::vector<AllCounts> blocks;
  blocks.reserve(blocks_.size());
  for (const auto& [key, block] : blocks_) blocks.push_back(block);
  return blocks;
}

AllCounts MeasuredGames::total() const {
  AllCounts total;
  for (const auto& [key, block] : blocks_) total = std::move(total) + block;
  return total;
}

}  // namespace autoref::logs
