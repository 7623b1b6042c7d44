// Settings of an experiment that differ from the defaults.
#pragma once

#include <string>
#include <vector>

#include "experiments/kinds/experiment.hpp"

namespace autoref::experiments {

struct DefaultDifference {
  std::string path;  // such as "match.half_s"
  std::string here;
  std::string by_default;
};

// Differences in the settings common to all games and in those of each named team, from the
// defaults of the experiment's rule book. Excludes settings determined by factors or the schedule.
std::vector<DefaultDifference> differences_from_defaults(const Experiment& experiment);

}  // namespace autoref::experiments
