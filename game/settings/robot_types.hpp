// Robot types: files that override some of the game's robot settings.
//
//   schema: 1
//   kind: robot
//   about: One sentence.
//   robot: { speed_mps: 2.2 }       # keys as below `sim.`; anything not given is unchanged
//   kicker: { ... }
//   dribbler: { ... }
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/settings/game_settings.hpp"

namespace autoref::game {

// Reads a type as strictly as a scenario. Throws InputError with file, line and key.
RobotChanges read_robot_type_text(const std::string& text, const std::string& file_name);

// Returns whether a user's `text` for a type is the path of a file, not a name.
bool is_type_file(std::string_view text);

// Resolves a type that a user gave as `text` and returns its name in `types`. `text` is a name in
// `types` or the path of a file relative to `folder`, which is then read into `types`;
// "robots/slow.yaml" becomes "slow". Throws std::invalid_argument if the file cannot be read or
// another type has that name, and InputError for errors inside the file.
std::string take_type(const std::string& text, const std::filesystem::path& folder,
                      RobotTypes& types);

// The existing type files named by the values of a scenario or scene; none if that is a pipe, which
// can be read only once.
std::vector<std::string> type_files_in(const std::filesystem::path& file);

// Maximum number of types per game.
inline constexpr std::size_t kMostTypes = 1000;

// Throws std::invalid_argument if there are more than kMostTypes.
void check_type_count(const RobotTypes& types);

// Describes what is wrong with a type's name; nullopt if it consists of letters, digits, - and _.
std::optional<std::string> fault_in_type_name(std::string_view name);

}  // namespace autoref::game
