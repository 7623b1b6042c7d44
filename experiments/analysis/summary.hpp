// A sweep's results for each of its values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/schedule/factor.hpp"
#include "experiments/statistics/interval.hpp"
#include "io/table.hpp"

namespace autoref::experiments {

// One group per combination of the factors' values, in the sweep's order.
std::vector<Group> grouped(const std::vector<Factor>& factors, const RowsById& rows);

struct Slope {
  double mean = 0;
  std::optional<Interval> interval;  // nullopt if there is only one pair, or if all pairs agree
  std::size_t pairs = 0;
};

// How much the score difference changes per unit of the factor's value. Pairs with the same number
// have the same seeds at every value, so their games are not independent. Each pair number
// therefore gives one slope, by least squares over the values; these slopes are an independent
// sample, and their mean and its Student's t confidence interval are returned. Pair numbers with a
// void or missing leg at any value are left out. Returns nullopt unless the sweep has exactly one
// factor, with at least two values, and all values are numbers.
std::optional<Slope> slope_over_factor(const std::vector<Factor>& factors,
                                       const std::vector<Group>& groups);

// summary.csv: one row per combination. The row starts with summary_columns(). Then it compares "a
// minus b" with the first combination, over the pair numbers that both combinations have
// (difference_columns(), groups.hpp), with Holm's correction over all rows. The numbers and
// fractions of games won, drawn and lost come last.
std::string summary_csv(const std::vector<Factor>& factors, const std::vector<Group>& groups);

// The rows of the text table, starting with its header, and the line of text about
// slope_over_factor(), which is empty if the slope is unknown.
std::vector<io::Cells> summary_rows(const std::vector<Factor>& factors,
                                    const std::vector<Group>& groups);
std::string slope_text(const std::vector<Factor>& factors, const std::optional<Slope>& slope);

// The table and the line about the slope as lines of text.
io::TextBlocks summary_table(const std::vector<Factor>& factors, const std::vector<Group>& groups,
                             const std::optional<Slope>& slope);

}  // namespace autoref::experiments
