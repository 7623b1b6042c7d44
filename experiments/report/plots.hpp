// The plots of an experiment's results. Each function returns nullopt if there is nothing to draw.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "experiments/kinds/scenario.hpp"
#include "experiments/report/plot.hpp"

namespace autoref::experiments {

// Names of all plots that a report may contain.
inline constexpr std::array kPlotNames = {"scores",     "difference",   "effects",
                                          "crosstable", "ratings",      "versions",
                                          "histogram",  "running_mean", "tuning_path"};

// All plots that apply to the experiment, in the order of the report.
std::vector<Plot> plots_of(const Scenario& scenario, const ExperimentResults& results);

// Mean and standard deviation of both teams' goals against the value of a factor, in the form of
// the paper's Fig. 5. Returns nullopt unless there is a single numeric factor.
std::optional<Plot> scores_plot(const Scenario& scenario, const ExperimentResults& results);

// Mean goal difference of each group with its 95 % interval: a curve for a single numeric factor,
// otherwise one row per group.
std::optional<Plot> difference_plot(const Scenario& scenario, const ExperimentResults& results);

// Each effect of a sweep's factors with its 95 % interval, one row per effect. Returns nullopt
// unless the experiment is a sweep with several factors.
std::optional<Plot> effects_plot(const ExperimentResults& results);

// Number of games by goal difference, one row of bars per group.
std::optional<Plot> histogram_plot(const Scenario& scenario, const ExperimentResults& results);

// Mean goal difference with its 95 % interval after each pair of legs, one panel per group.
std::optional<Plot> running_mean_plot(const Scenario& scenario, const ExperimentResults& results);

// Mean goal difference of each team against every other team. Returns nullopt if there are no
// standings.
std::optional<Plot> crosstable_plot(const ExperimentResults& results);

// Each parameter of a tuning after every iteration, one panel per parameter.
std::optional<Plot> tuning_path_plot(const ExperimentResults& results);

// Both ratings of each team with their 95 % intervals. Returns nullopt if there are no standings.
std::optional<Plot> ratings_plot(const ExperimentResults& results);

// Rating of each version over its date with its 95 % interval, a curve per line of versions.
// Ratings that were taken over with an offset are open circles, and a vertical line marks a change
// of the build. Returns nullopt if no version has a rating.
std::optional<Plot> versions_plot(const ExperimentResults& results);

}  // namespace autoref::experiments
