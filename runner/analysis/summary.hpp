// What a sweep's rows say, value by value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/analysis/groups.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/statistics/interval.hpp"

namespace autoref::runner {

// A group for each combination of the factors' values, in the sweep's order.
std::vector<Group> grouped(const Sweep& sweep, const RowsById& rows);

struct Slope {
  double mean = 0;
  std::optional<Interval> interval;  // none for a single pair
};

// How much the score difference changes per unit of the factor. Pairs of one number have the same
// seeds at every value, so their games are not independent: each pair number gives one slope, by
// least squares over the values, and those slopes are the independent sample whose mean and
// Student interval these are. Pair numbers without two good legs at every value are left out. None
// where the sweep has not exactly one factor with at least two values, all numbers.
std::optional<Slope> slope_over_factor(const Sweep& sweep, const std::vector<Group>& groups);

// summary.csv: per combination what summary_cells() says, then how much "a minus b" differs from
// the first combination's, over the pair numbers that both have: mean, interval, p of no
// difference, that p with Holm's correction over all rows, and effect size
// (statistics/paired_difference.hpp); last the games won, drawn and lost with their shares.
std::string summary_csv(const Sweep& sweep, const std::vector<Group>& groups);

// The table for people, the head first, and the line on the slope; empty where there is none.
std::vector<Cells> summary_rows(const Sweep& sweep, const std::vector<Group>& groups);
std::string slope_text(const Sweep& sweep, const std::vector<Group>& groups);

// Both as text, several lines.
std::string summary_table(const Sweep& sweep, const std::vector<Group>& groups);

}  // namespace autoref::runner
