// Types of robots: files that say what some robots have other than the game's.
//
//   schema: 1
//   kind: robot
//   about: One sentence.
//   robot: { speed_mps: 2.2 }       # keys as below `sim.`; what is not given stays as it is
//   kicker: { ... }
//   dribbler: { ... }
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runner/settings/configuration.hpp"

namespace autoref::runner {

// Reads a type as strictly as a scenario. Throws InputError with file, line and key.
RobotChanges read_robot_type_text(const std::string& text, const std::string& file_name);

// The name in `types` of the type that a user gave as `text`: the name itself, or the path of a
// file, relative to `folder`, that is read into `types`; "robots/slow.yaml" is called "slow".
// Throws std::invalid_argument where the file cannot be read or another type has its name, and
// InputError for what is wrong inside it.
std::string take_type(const std::string& text, const std::filesystem::path& folder,
                      RobotTypes& types);

// The files that the values of a scenario or scene name as types, as far as they are there.
std::vector<std::string> type_files_in(const std::filesystem::path& file);

// A game has at most so many types.
inline constexpr std::size_t kMostTypes = 1000;

// Throws std::invalid_argument where there are more.
void check_type_count(const RobotTypes& types);

// Throws std::invalid_argument unless a type may be called so: letters, digits, - and _.
void check_type_name(std::string_view name);

// set_by_path() (fields.hpp) that also takes the path of a file for a type, relative to `folder`.
void set_by_path(GameConfiguration& game, std::string_view path, const std::string& text,
                 const std::filesystem::path& folder);

// The same for a team whose settings are at `prefix`, such as "teams.bold."; its types, and what is
// given, go into `game`.
void set_by_path(TeamConfiguration& team, const std::string& prefix, GameConfiguration& game,
                 std::string_view path, const std::string& text);

}  // namespace autoref::runner
