// Settings that the command line changes.
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

// One `--set KEY=VALUE`.
struct Assignment {
  std::string flag;  // for messages: "--set match.half_s=60"
  std::string path;  // full or short
  std::string value;
};

using Assignments = std::vector<Assignment>;

// Throws InputError where one is not KEY=VALUE, or where one sets a handicap and another a part of
// it.
Assignments assignments_in(const std::vector<std::string>& sets);

// All flags in one, for messages about what they mean together.
std::string flags_of(const Assignments& assignments);

// Throws InputError that names the flag.
void assign(const Assignment& assignment, GameConfiguration& game);

// Applies them all and checks the game that comes of them. Throws InputError.
void assign_all(const Assignments& assignments, GameConfiguration& game);

}  // namespace autoref::runner
