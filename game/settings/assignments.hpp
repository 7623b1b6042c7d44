// Settings given on the command line.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"

namespace autoref::game {

// Runs `change` and turns its errors into InputErrors that name `location`, a flag or a file.
template <typename Change>
void locate_errors(const std::string& location, const Change& change) {
  try {
    change();
  } catch (const std::invalid_argument& error) {
    throw io::InputError({location}, "", error.what());
  }
}

// One `--set KEY=VALUE`.
struct Assignment {
  std::string flag;  // for messages: "--set match.half_s=60"
  std::string path;  // full or short path of the setting
  std::string value;
};

using Assignments = std::vector<Assignment>;

// Spaces around the equals sign do not count. Throws InputError if a string is not KEY=VALUE. Also
// throws it if one string sets a handicap and another one sets one of the factors of that handicap.
Assignments assignments_in(const std::vector<std::string>& sets);

// All flags in one string, for messages about their combined effect.
std::string flags_of(const Assignments& assignments);

// Applies one assignment. Throws InputError naming the flag.
void assign(const Assignment& assignment, GameSettings& game);

// Applies all assignments and checks the resulting game. Throws InputError.
void assign_all(const Assignments& assignments, GameSettings& game);

}  // namespace autoref::game
