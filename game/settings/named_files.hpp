// Files that a user gives where a setting expects a name: robot types (robot_types.hpp) and presets
// (measured_presets.hpp). The name of "robots/slow.yaml" is "slow".
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/settings/game_settings.hpp"

namespace autoref::game {

inline constexpr const char* kRobotType = "robot type";
inline constexpr const char* kPreset = "preset";

struct NamedFile {
  std::string what;   // kRobotType or kPreset
  std::string given;  // as the user wrote it
  std::string name;
  std::string path;
  std::string text;
};

// Returns whether `text` is the path of a file and not a name.
bool is_settings_file(std::string_view text);

// The existing files of that kind named by the values of a scenario or scene. Returns none if
// `file` is a pipe, since that can be read only once.
std::vector<std::string> settings_files_in(const std::filesystem::path& file);

// Reads the file that a user gave as `given`, relative to `folder`. Throws std::invalid_argument if
// it cannot be read or if its name is not allowed.
NamedFile read_named_file(const std::string& given, const std::filesystem::path& folder,
                          const std::string& what);

// Describes what is wrong with the name; nullopt if it consists of letters, digits, - and _.
std::optional<std::string> fault_in_name(std::string_view name, std::string_view what);

// Maximum number of robot types, and of presets from files, per game.
inline constexpr std::size_t kMostNames = 1000;

// Throws std::invalid_argument if there are more than kMostNames.
void check_name_count(std::size_t count, std::string_view what);

// Throws std::invalid_argument saying that another type or preset has the file's name.
[[noreturn]] void refuse_name(const NamedFile& file);

// Adds the file's content to `known`. Throws std::invalid_argument if there are too many, or if
// another file with that name has different content.
template <typename Content>
void add_named(const NamedFile& file, const Content& content,
               std::map<std::string, Content>& known) {
  const auto [there, is_new] = known.try_emplace(file.name, content);
  check_name_count(known.size(), file.what);
  if (!is_new && !(there->second == content)) refuse_name(file);
}

}  // namespace autoref::game
