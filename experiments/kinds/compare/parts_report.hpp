// The parts of a comparison's difference (experiments/analysis/difference_parts.hpp) as a sentence,
// a table, a CSV file and JSON.
#pragma once

#include <optional>
#include <string>

#include "experiments/analysis/difference_parts.hpp"
#include "experiments/statistics/interval.hpp"
#include "io/json.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// "+0.42 [+0.11, +0.73]". Numbers that would read as zero have a third decimal. Only the mean
// without an interval.
std::string mean_with_interval(double mean, const std::optional<Interval>& interval);

// The same with its unit: "+0.42 goals per game [+0.11, +0.73]".
std::string goals_with_interval(double mean, const std::optional<Interval>& interval);

// "Most certain part of the difference: chances from corner kicks, -0.16 goals per game [-0.22,
// -0.10]." If only the correction for the number of parts makes that part uncertain: "No single
// part of the difference is certain. The strongest candidate: ...".
std::string most_certain_text(const DifferenceParts& parts);

// The parts that are not zero, and their sums. `has_opponents`: whether there are common
// opponents, so that the table has columns for the sources of the difference.
io::TextBlocks parts_table(const DifferenceParts& parts, bool has_opponents);

// parts.csv: one row per part, then those of the sums.
std::string parts_csv(const DifferenceParts& parts);

// A list of objects with the columns of parts.csv except `p`.
io::Json parts_json(const DifferenceParts& parts);

}  // namespace autoref::experiments
