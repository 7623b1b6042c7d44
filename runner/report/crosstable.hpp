// Each team against each, from its own side.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runner/batch/experiment_kinds.hpp"

namespace autoref::runner {

// What one team reached against another.
struct CrossCell {
  int wins = 0;
  int draws = 0;
  int losses = 0;
  std::optional<double> mean_difference;  // none without games

  int points() const { return 3 * wins + draws; }
};

// cells[row][column] is the row's team against the column's; a team has none against itself, nor
// against one that it did not meet.
struct Crosstable {
  std::vector<std::string> teams;  // best first
  std::vector<std::vector<std::optional<CrossCell>>> cells;
};

// Of results with standings and groups of two teams each; none of others.
std::optional<Crosstable> crosstable_of(const ExperimentResults& results);

}  // namespace autoref::runner
