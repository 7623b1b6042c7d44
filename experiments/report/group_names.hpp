// Names for an experiment's groups in a report, and the x axis of plots over a numeric factor.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/analysis/groups.hpp"
#include "experiments/kinds/scenario.hpp"

namespace autoref::experiments {

// Headers of the columns with the groups' values: a sweep's paths, or "a" and "b" for two teams.
std::vector<std::string> value_heads(const Scenario& scenario, const std::vector<Group>& groups);

// Axis label that says how the groups differ: "b.handicap", "a.robots, b.robots", "matchup".
std::string axis_name(const Scenario& scenario);

// A name for each group: "0.75" if there is a single factor, "5, 6" if there are several, "bold :
// zone" for a matchup.
std::vector<std::string> names_of(const Scenario& scenario, const std::vector<Group>& groups);

// A single factor with numeric values.
struct NumericFactor {
  std::string path;
  std::vector<double> values;  // the factor's value in each group

  // The first value is the baseline and is on the left of the axis, even if it is the largest.
  bool is_falling() const { return values.front() > values.back(); }
};

// Returns nullopt if there is not exactly one factor, if the factor has fewer than two values, or
// if one of them is not a number.
std::optional<NumericFactor> numeric_factor(const Scenario& scenario,
                                            const std::vector<Group>& groups);

// Script lines that label the axis with the factor's values, with the baseline on the left.
std::string factor_axis(const NumericFactor& factor, const std::vector<Group>& groups);

// Horizontal shift that separates two marks at the same value, in the factor's unit.
double dodge_of(const NumericFactor& factor);

// Returns whether any group has a game that is not void.
bool has_games(const std::vector<Group>& groups);

}  // namespace autoref::experiments
