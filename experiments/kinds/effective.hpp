// Writes effective.yaml.
#pragma once

#include <string>

#include "experiments/kinds/scenario.hpp"

namespace autoref::experiments {

// The scenario with every setting spelt out and explained in a comment. Reading it back yields the
// same scenario. Throws InputError if the text would be too long to read back.
std::string effective_text(const Scenario& scenario);

}  // namespace autoref::experiments
