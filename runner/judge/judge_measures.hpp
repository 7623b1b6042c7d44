// Measures of how well an event was called.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/judge/judge_tally.hpp"

namespace autoref::runner {

// A measure of an event, with its names in tables and in files.
struct Measure {
  const char* head;  // heading of the table's column; nullptr: only in CSV and JSON
  const char* name;
  // nullopt if there is nothing to measure.
  std::optional<double> (*value)(const EventTally& tally);
  int decimals = 0;  // shown
};

// A measure's value as a cell of a table; empty if there is no value.
std::string text_of(const Measure& measure, const EventTally& tally);

// All measures, in the order of the tables' columns.
const std::vector<Measure>& measures();

}  // namespace autoref::runner
