// What a report calls an experiment's groups.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/analysis/groups.hpp"
#include "runner/batch/experiment_kinds.hpp"
#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// What heads the values of each group: a sweep's paths, "a" and "b" over two teams.
std::vector<std::string> value_heads(const Scenario& scenario, const std::vector<Group>& groups);

// What is different between the groups, for an axis: "b.handicap", "a.robots, b.robots", "matchup".
std::string axis_name(const Scenario& scenario);

// A name for each group: "0.75" of a single factor, "5, 6" of several, "bold : zone" of a matchup.
std::vector<std::string> names_of(const Scenario& scenario, const std::vector<Group>& groups);

// A single factor over numbers.
struct NumericFactor {
  std::string path;
  std::vector<double> values;  // of each group

  // The first value is the baseline and stands at the left, even where it is the greatest.
  bool is_falling() const { return values.front() > values.back(); }
};

// None where there are several factors or none, fewer than two values, or one that is no number.
std::optional<NumericFactor> numeric_factor(const Scenario& scenario,
                                            const std::vector<Group>& groups);

}  // namespace autoref::runner
