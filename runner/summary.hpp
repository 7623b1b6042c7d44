// What an experiment's rows say, value by value.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runner/rows.hpp"
#include "runner/scenario.hpp"
#include "runner/statistics.hpp"

namespace autoref::runner {

// The games of one combination of the factors' values. Void games count only in `void_games`.
struct Group {
  std::vector<std::string> values;
  std::vector<double> goals_a;  // of each game
  std::vector<double> goals_b;
  std::vector<double> differences;  // a minus b
  // By pair number: mean over the two legs, of pairs without a void leg.
  std::map<std::string, double> pair_differences;
  int void_games = 0;
};

// The groups in the sweep's order. `rows` are complete rows, each game once, in any order.
std::vector<Group> grouped(const Sweep& sweep, const RowFormat& format,
                           const std::vector<Cells>& rows);

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

// summary.csv: per combination its games, means and standard deviations (over games), and the 95 %
// interval of the mean difference (over pairs). Cells without a value are empty.
std::string summary_csv(const Sweep& sweep, const std::vector<Group>& groups);

// The table for people, several lines.
std::string summary_table(const Sweep& sweep, const std::vector<Group>& groups);

}  // namespace autoref::runner
