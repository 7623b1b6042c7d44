// The key of the parameters that a tuning changes.
#pragma once

#include "experiments/kinds/tune/tuning.hpp"

namespace autoref::experiments {

// `tune`: parameters by name. Reads a parameter's range and start from the strategy's own
// description, if it has one, so the team must have been read before.
Key parameters_key(Tuning& tuning);

}  // namespace autoref::experiments
