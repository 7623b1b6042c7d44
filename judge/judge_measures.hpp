// Measures of how well an event was called.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/judge_tally.hpp"

namespace autoref::judge {

// A measure of an event, with its names in tables and in files.
struct Measure {
  const char* head;  // heading of the table's column
  const char* name;
  // The value of the measure; nullopt if there is nothing to measure.
  std::optional<double> (*value)(const EventTally& tally);
  int decimals = 0;  // number of decimals shown
  // The 95 % confidence interval, nullopt if there is nothing to measure. The function is null if
  // the measure has no interval.
  std::optional<experiments::Interval> (*interval)(const EventTally& tally) = nullptr;
};

// All measures, in the order of the tables' columns.
const std::vector<Measure>& measures();

// A measure's value as a cell of a table, with its interval: "0.991 [0.980, 0.996]"; empty if there
// is no value.
std::string text_of(const Measure& measure, const EventTally& tally);

// A number as written to a file.
struct MeasuredNumber {
  std::string name;  // "recall"; for the interval, "recall_low95" and "recall_high95"
  std::optional<double> value;
  int decimals = 0;
};

// All measures' values and intervals, in the order of judge.csv's columns.
std::vector<MeasuredNumber> numbers_of(const EventTally& tally);

// "0.980, 0.996".
std::string text_of(const experiments::Interval& interval, int decimals);

}  // namespace autoref::judge
