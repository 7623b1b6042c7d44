// All kinds of experiments.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/kinds/experiment.hpp"

namespace autoref::experiments {

// All kinds, in the order of help and reference pages.
std::span<const Kind* const> kinds_of_experiments();

// Null if no kind has this name.
const Kind* find_kind(std::string_view name);

// The kinds that the verb plays, as text: "sweep, roundrobin or tune".
std::string kinds_played_by(std::string_view verb);

}  // namespace autoref::experiments
