// Reads the keys specific to `kind: tune`.
#pragma once

#include "runner/experiments/reading/top_reader.hpp"
#include "runner/experiments/tuning.hpp"

namespace autoref::runner {

// Throws InputError.
Tuning read_tuning(TopReader& top);

}  // namespace autoref::runner
