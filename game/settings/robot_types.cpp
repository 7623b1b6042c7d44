#include "game/settings/robot_types.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

#include "game/settings/setting_value.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "io/errors.hpp"
#include "io/files.hpp"

namespace autoref::game {
namespace {

namespace fs = std::filesystem;

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// If the file cannot be read, the error belongs to the setting that names it.
std::string text_of_type(const fs::path& file) {
  try {
    return io::read_user_file(file);
  } catch (const io::InputError& error) {
    throw std::invalid_argument(error.what());
  }
}

void add_files_in(const YAML::Node& node, const fs::path& folder, std::vector<std::string>& files) {
  std::error_code error;
  if (node.IsScalar() && is_type_file(node.Scalar()) &&
      fs::is_regular_file(folder / node.Scalar(), error))
    files.push_back((folder / node.Scalar()).string());
  for (const auto& item : node) add_files_in(node.IsMap() ? item.second : item, folder, files);
}

const Setting& robot_setting(const std::vector<Setting>& settings, const std::string& path) {
  const Setting* found = find_setting(settings, path);
  if (found == nullptr) throw std::logic_error("unknown robot setting " + path);
  return *found;
}

sim::TeamSpec spec_of(const GameSettings& game, const TeamSettings& team) {
  sim::RobotSpec robot = game.robot;
  apply_changes(merged(game.types, team.type, team.changes), robot);
  robot.speed_factor = team.speed_factor;
  robot.acceleration_factor = team.acceleration_factor;
  sim::TeamSpec spec{sim::TeamSpec::Robots(static_cast<std::size_t>(team.robots), robot)};
  for (const auto& [number, player] : team.players) {
    if (number >= team.robots) {
      throw SettingError(fmt::format("players.{}", number),
                         fmt::format(": the team's robots are numbered 0 to {}", team.robots - 1));
    }
    sim::RobotSpec& own = spec.robots[static_cast<std::size_t>(number)];
    apply_changes(merged(game.types, player.type, player.changes), own);
    own.speed_factor *= player.speed_factor;
    own.acceleration_factor *= player.acceleration_factor;
  }
  return spec;
}

}  // namespace

bool is_type_file(std::string_view text) {
  return text.find('/') != std::string_view::npos || text.ends_with(".yaml");
}

std::vector<std::string> type_files_in(const fs::path& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) return {};
  const YamlFile yaml(io::read_user_file(file), file.string());
  std::vector<std::string> files;
  for (const YamlEntry& entry : yaml.top()) add_files_in(entry.value, yaml.folder(), files);
  return files;
}

RobotChanges read_robot_type_text(const std::string& text, const std::string& file_name) {
  const YamlFile file(text, file_name);
  const std::vector<YamlEntry> top = file.top();
  expect_value(file, top, "schema", "1");
  expect_value(file, top, "kind", "robot");
  refuse_unknown(file, top, {"schema", "kind", "about", "robot", "kicker", "dribbler"});
  if (const YamlEntry* about = find_entry(top, "about")) {
    file.scalar(*about, "about", "a sentence", false);
  }
  RobotChanges changes;
  SettingLocations locations;
  SettingsReader reader(file, settings_of(changes), locations);
  for (const char* branch : {"robot", "kicker", "dribbler"}) {
    if (const YamlEntry* entry = find_entry(top, branch)) reader.read(*entry, branch);
  }
  return changes;
}

std::string take_type(const std::string& text, const fs::path& folder, RobotTypes& types) {
  if (!is_type_file(text)) return text;
  const fs::path file = folder / text;
  std::string name = file.stem();
  if (const std::optional<std::string> fault = fault_in_type_name(name)) {
    throw std::invalid_argument(
        fmt::format("the type is named after its file: {}; rename the file", *fault));
  }
  const RobotChanges changes = read_robot_type_text(text_of_type(file), file.string());
  const auto [there, is_new] = types.try_emplace(name, changes);
  check_type_count(types);
  if (!is_new && there->second != changes) {
    throw std::invalid_argument(
        fmt::format("another type is already called '{}'; rename the file {}", name, text));
  }
  return name;
}

void check_type_count(const RobotTypes& types) {
  if (types.size() <= kMostTypes) return;
  throw std::invalid_argument(
      fmt::format("there are more than {} robot types, the maximum for one game", kMostTypes));
}

std::optional<std::string> fault_in_type_name(std::string_view name) {
  const bool is_word = !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return is_letter_or_digit(c) || c == '-' || c == '_';
  });
  if (is_word && name != kNoType) return std::nullopt;
  return fmt::format(
      "a type's name may only contain letters, digits, - and _, and may not be '{}'; found '{}'",
      kNoType, name);
}

RobotChanges merged(const RobotTypes& types, const std::string& type, const RobotChanges& changes) {
  RobotChanges all = changes;
  if (type == kNoType) return all;
  const auto found = types.find(type);
  if (found == types.end()) {
    throw SettingError("type", fmt::format(": unknown robot type '{}'", type));
  }
  all.insert(found->second.begin(), found->second.end());
  return all;
}

void apply_changes(const RobotChanges& changes, sim::RobotSpec& robot) {
  if (changes.empty()) return;
  const std::vector<Setting> settings = settings_of(robot, "");
  for (const auto& [path, value] : changes) set_value(robot_setting(settings, path), value);
}

void set_change(const Change& change, const SettingValue& value) {
  sim::RobotSpec robot;
  apply_changes(*change.changes, robot);
  const std::vector<Setting> settings = settings_of(robot, "");
  const Setting& changed = robot_setting(settings, change.path);
  set_value(changed, value);
  for (const Setting& setting : settings) {
    // A preset sets several values. Record its whole branch, including values that a default robot
    // already has: the changes will be applied to another robot.
    const bool is_set = is_alias(changed) ? branch_of(setting.path) == branch_of(change.path)
                                          : setting.path == change.path;
    if (is_set && !is_alias(setting)) (*change.changes)[setting.path] = current_value(setting);
  }
}

SettingValue changed_value(const Change& change) {
  sim::RobotSpec robot;
  apply_changes(*change.changes, robot);
  return current_value(robot_setting(settings_of(robot, ""), change.path));
}

sim::TeamSpec spec_of(const GameSettings& game, const TeamSettings& team, std::string_view path) {
  try {
    return spec_of(game, team);
  } catch (const SettingError& error) {
    throw error.below(path);
  }
}

}  // namespace autoref::game
