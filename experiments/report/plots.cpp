#include "experiments/report/plots.hpp"

namespace autoref::experiments {

std::vector<Plot> plots_of(const Scenario& scenario, const ExperimentResults& results) {
  std::vector<Plot> plots;
  for (const std::optional<Plot>& plot :
       {scores_plot(scenario, results), difference_plot(scenario, results), effects_plot(results),
        crosstable_plot(results), ratings_plot(results), histogram_plot(scenario, results),
        running_mean_plot(scenario, results), tuning_path_plot(results)}) {
    if (plot) plots.push_back(*plot);
  }
  return plots;
}

}  // namespace autoref::experiments
