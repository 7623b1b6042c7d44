// Which settings of an experiment are not the defaults.
#pragma once

#include <string>
#include <vector>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

struct DefaultDifference {
  std::string path;  // such as "match.half_s"
  std::string here;
  std::string by_default;
};

// Of what all games have in common, and of each named team; the defaults are those of the
// experiment's rule book. Without what factors and the plan decide.
std::vector<DefaultDifference> differences_from_defaults(const Scenario& scenario);

}  // namespace autoref::runner
