// The figures that tell how well an event was judged.
#pragma once

#include <string>
#include <vector>

#include "runner/judge/judge_tally.hpp"

namespace autoref::runner {

// A figure of an event: how a table and how a program names it.
struct Measure {
  const char* head;  // of the table's column; nullptr: in CSV and JSON only
  const char* name;
  std::string (*text)(const EventTally& tally);
};

// In the order of the tables' columns.
const std::vector<Measure>& measures();

}  // namespace autoref::runner
