// What the new team of a comparison does differently (experiments/analysis/play_differences.hpp) as
// a sentence, a table, a CSV file and JSON.
#pragma once

#include <string>
#include <vector>

#include "experiments/analysis/play_differences.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// "Most certain difference in play: chains from corner kicks, 0.00 per game instead of 4.52."
std::string most_certain_text(const std::vector<PlayDifference>& differences);

// At most eight of the certain differences; empty if none is certain.
io::TextBlocks play_table(const std::vector<PlayDifference>& differences);

// play.csv: one row per difference.
std::string play_csv(const std::vector<PlayDifference>& differences);

// A list of objects with the columns of play.csv except `p`.
io::Json play_json(const std::vector<PlayDifference>& differences);

}  // namespace autoref::experiments
