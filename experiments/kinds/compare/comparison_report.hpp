// The results of a comparison as a sentence, a table, CSV files and JSON.
#pragma once

#include <string>

#include "experiments/kinds/compare/compared_teams.hpp"
#include "experiments/kinds/compare/comparison.hpp"
#include "experiments/kinds/results.hpp"

namespace autoref::experiments {

// The answer in one sentence: "new is better than old: +0.42 goals per game [+0.11, +0.73], decided
// after 86 games; p = 0.0041".
std::string answer(const Comparison& comparison, const ComparedTeams& compared);

// The tables and comparison.csv contain only the pair numbers that the test considered; summary.csv
// and the groups contain all games.
ExperimentResults comparison_results(const Comparison& comparison, const RowsById& rows);

}  // namespace autoref::experiments
