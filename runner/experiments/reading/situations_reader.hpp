// Reads `kind: situations`.
#pragma once

#include "runner/experiments/reading/top_reader.hpp"
#include "runner/experiments/situations.hpp"

namespace autoref::runner {

// Throws InputError.
Situations read_situations(TopReader& top);

}  // namespace autoref::runner
