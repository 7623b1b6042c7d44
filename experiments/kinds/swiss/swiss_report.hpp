// The rounds of a Swiss tournament as a CSV file and as a text table.
#pragma once

#include <string>

#include "experiments/kinds/results.hpp"
#include "experiments/kinds/swiss/swiss_rounds.hpp"

namespace autoref::experiments {

// rounds.csv: round by round, a row per meeting with its teams, games, void games and points so
// far, then a row for the bye.
std::string rounds_csv(const SwissRounds& played);

// Adds rounds.csv, the table of rounds before the others, and what a bye is worth after them.
void add_rounds(ExperimentResults& results, const SwissRounds& played);

}  // namespace autoref::experiments
