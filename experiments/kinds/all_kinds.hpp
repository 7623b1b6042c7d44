// All kinds of experiments.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/kinds/experiment.hpp"

namespace autoref::experiments {

// All kinds, in the order in which the help and the reference pages list them.
std::span<const Kind* const> kinds_of_experiments();

// The kind with this name; null if there is none.
const Kind* find_kind(std::string_view name);

// The kinds that the verb plays, as text: "sweep, roundrobin or tune".
std::string kinds_played_by(std::string_view verb);

}  // namespace autoref::experiments
