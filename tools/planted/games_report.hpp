// The page about the games that measures need to find planted changes.
#pragma once

#include <string>
#include <vector>

#include "experiments/report/document.hpp"
#include "tools/planted/measured_difference.hpp"

namespace autoref::tools {

// The name of the measure that the page's answer is about.
inline constexpr const char* kXg = "xG";

struct MeasuredChange {
  std::string name;
  std::vector<MeasuredDifference> measures;  // goals first; the same measures for every change
};

// What a change shows about a measure, compared with goals.
enum class GamesVerdict {
  kUnknown,    // the 95 % interval of the difference in goals contains 0
  kFewer,      // the measure needs fewer games than goals
  kMore,       // it needs more
  kUncertain,  // the interval of RelativeGames contains 1
};

GamesVerdict verdict_of(const MeasuredDifference& measured, const MeasuredDifference& goals);

// Tables of all changes and measures, and the answer for xG. All sentences follow from the numbers.
experiments::Document games_report(const std::vector<MeasuredChange>& changes, int pairs);

}  // namespace autoref::tools
