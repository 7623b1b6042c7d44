// The plots of an experiment's results. Each function gives none where there is nothing to draw.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "runner/batch/experiment_kinds.hpp"
#include "runner/experiments/scenario.hpp"
#include "runner/report/plot.hpp"

namespace autoref::runner {

// Every name that a plot of a report may have.
inline constexpr std::array kPlotNames = {"scores",  "difference", "crosstable",
                                          "ratings", "histogram",  "running_mean"};

// All that fit the experiment, in the order of a report.
std::vector<Plot> plots_of(const Scenario& scenario, const ExperimentResults& results);

// The form of the paper's Fig. 5: mean and standard deviation of both teams' goals against the
// value of a factor. Only over a single factor of numbers.
std::optional<Plot> scores_plot(const Scenario& scenario, const ExperimentResults& results);

// The mean goal difference of each group with its 95 % interval: a curve over a single factor of
// numbers, else a row for each group.
std::optional<Plot> difference_plot(const Scenario& scenario, const ExperimentResults& results);

// How many games ended with which goal difference, a row of bars for each group.
std::optional<Plot> histogram_plot(const Scenario& scenario, const ExperimentResults& results);

// The mean goal difference with its 95 % interval after each pair of legs, a panel for each group.
std::optional<Plot> running_mean_plot(const Scenario& scenario, const ExperimentResults& results);

// Of teams that have standings: the mean goal difference of each against each.
std::optional<Plot> crosstable_plot(const ExperimentResults& results);

// Of teams that have standings: both ratings with their 95 % intervals.
std::optional<Plot> ratings_plot(const ExperimentResults& results);

}  // namespace autoref::runner
