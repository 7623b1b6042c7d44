// Writes a scenario with every setting spelt out: what `effective.yaml` holds.
#pragma once

#include <string>

#include "runner/experiments/scenario.hpp"

namespace autoref::runner {

// The scenario with every setting spelt out, each with its meaning as a comment. Reading it gives
// the same scenario again. Throws InputError where that would be more text than can be read.
std::string effective_text(const Scenario& scenario);

}  // namespace autoref::runner
