#include "game/settings/robot_types.hpp"

#include <fmt/format.h>
#include <stdexcept>

#include "game/settings/named_files.hpp"
#include "game/settings/setting_value.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"

namespace autoref::game {
namespace {

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

RobotChanges read_robot_type_text(const std::string& text, const std::string& file_name) {
  RobotChanges changes;
  read_settings_file(YamlFile(text, file_name), "robot", settings_of(changes));
  return changes;
}

std::string take_type(const std::string& text, const std::filesystem::path& folder,
                      RobotTypes& types) {
  if (!is_settings_file(text)) return text;
  const NamedFile file = read_named_file(text, folder, kRobotType);
  add_named(file, read_robot_type_text(file.text, file.path), types);
  return file.name;
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
