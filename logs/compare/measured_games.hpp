// The values of all measures in some logs, by blocks of time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "logs/compare/measures.hpp"

namespace autoref::logs {

// How often a measure had a value in each of its bins; the bins of a distribution are kBins equal
// parts from 0 to its highest value. A share has two: frames without and with the property. A rate
// has one: the events.
class MeasureCounts {
 public:
  static constexpr std::size_t kBins = 200;

  void add(const MeasureEntry& entry, double value);
  void add_time(double duration_s) { duration_s_ += duration_s; }
  void add(const MeasureCounts& other);
  void subtract(const MeasureCounts& other);

  std::span<const std::int64_t> bins() const { return bins_; }
  std::int64_t values() const { return values_; }
  double duration_s() const { return duration_s_; }  // of a rate: the time in which events count

 private:
  std::vector<std::int64_t> bins_;  // empty until the first value
  std::int64_t values_ = 0;
  double duration_s_ = 0;
};

using AllCounts = std::array<MeasureCounts, kMeasureCount>;

AllCounts operator+(AllCounts sum, const AllCounts& other);
AllCounts operator-(AllCounts difference, const AllCounts& other);

class MeasuredGames {
 public:
  // Blocks are the units of time that may be drawn again at random. They are longer than most of
  // what happens in play, so that they are nearly independent.
  static constexpr double kBlock_s = 5;
  // With more blocks than this, neighbours in a log are merged, so that memory is bounded by the
  // number of logs.
  static constexpr std::size_t kMostBlocks = 4096;

  // Starts the next log. Its times are unrelated to those of the logs before.
  void start_log() { ++logs_; }
  int logs() const { return logs_; }

  // Adds a value seen at `time_s` of log `log`, counted from 1. Ignores values and times that are
  // not finite.
  void add(int log, Measure measure, double time_s, double value);
  void add_time(int log, Measure measure, double time_s, double duration_s);
  // Removes what was added of a measure in a log.
  void discard(int log, Measure measure);

  std::vector<AllCounts> blocks() const;
  AllCounts total() const;

 private:
  AllCounts& block_at(int log, double time_s);
  void merge_neighbours();

  int logs_ = 0;
  double block_s_ = kBlock_s;
  std::size_t most_blocks_ = kMostBlocks;                     // more if there are so many logs
  std::map<std::pair<int, std::int64_t>, AllCounts> blocks_;  // by log and number
};

}  // namespace autoref::logs
