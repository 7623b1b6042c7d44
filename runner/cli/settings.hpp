// Settings that flags change.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "runner/io/errors.hpp"
#include "runner/settings/configuration.hpp"

namespace autoref::runner {

// Does `change`; what is wrong with it is blamed on `location`, a flag or a file, by an InputError.
template <typename Change>
void blame(const std::string& location, const Change& change) {
  try {
    change();
  } catch (const std::invalid_argument& error) {
    throw InputError({location}, "", error.what());
  }
}

// Applies "key=value" as --set gives them, in their order, and checks the game that comes of it.
// Throws InputError that names the flag.
void apply_sets(const std::vector<std::string>& sets, GameConfiguration& game);

}  // namespace autoref::runner
