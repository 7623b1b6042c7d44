// The page of `autoref log compare`.
#pragma once

#include <string>

#include "logs/compare/distance_report.hpp"
#include "logs/compare/game_comparison.hpp"
#include "logs/compare/measured_games.hpp"

namespace autoref::app {

struct ComparisonPage {
  std::string html;
  std::string trouble;  // why plots are missing, in one line; empty if none is
};

// A self-contained page with the table, the distances as a plot, and for each distribution the
// shares of values below any bound.
ComparisonPage comparison_page(const logs::GameComparison& comparison,
                               const logs::ComparedTimes& times, const logs::AllCounts& recorded,
                               const logs::AllCounts& simulated);

}  // namespace autoref::app
