// What `autoref log compare` prints.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/table.hpp"
#include "logs/compare/game_comparison.hpp"

namespace autoref::logs {

// How much of the games was measured.
struct MeasuredTime {
  std::size_t logs = 0;
  double running_s = 0;  // duration of running play
};

struct ComparedTimes {
  MeasuredTime recorded;
  MeasuredTime simulated;
};

// A sentence on how much was compared, such as "Recorded: 2 logs, 0.9 min of running play. ..."
std::string compared_text(const ComparedTimes& times);

// The cells of the table of measures: a header, then a row per measure.
std::vector<std::vector<std::string>> comparison_rows(const GameComparison& comparison);

// A sentence on the mean distance.
std::string mean_text(const GameComparison& comparison);

io::TextBlocks comparison_text(const GameComparison& comparison, const ComparedTimes& times);

// A single-line JSON object (docs/schemas.md).
std::string comparison_json(const GameComparison& comparison, const ComparedTimes& times);

}  // namespace autoref::logs
