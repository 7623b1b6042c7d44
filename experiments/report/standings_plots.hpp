// Results of each team against every other team, and the plots of standings.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/kinds/scenario.hpp"

namespace autoref::experiments {

// Results of one team against another.
struct CrossCell {
  int wins = 0;
  int draws = 0;
  int losses = 0;
  std::optional<double> mean_difference;  // nullopt if there are no games

  int points() const { return kPointsOfWin * wins + draws; }
};

// cells[row][column] contains the result of the row's team against the column's team. A cell is
// nullopt on the diagonal and for teams that have not played each other.
struct Crosstable {
  std::vector<std::string> teams;  // best first
  std::vector<std::vector<std::optional<CrossCell>>> cells;
};

// Returns the table for results with standings and groups of two teams each, otherwise nullopt.
std::optional<Crosstable> crosstable_of(const ExperimentResults& results);

}  // namespace autoref::experiments
