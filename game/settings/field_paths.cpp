// Finds settings by path and name.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "game/settings/fields.hpp"
#include "game/settings/measured_presets.hpp"
#include "io/words.hpp"
#include "strategies/registry.hpp"

namespace autoref::game {
namespace {

// The paths that nearly end in `path`.
std::vector<std::string> paths_nearly_ending_in(std::string_view path,
                                                const std::vector<std::string>& known) {
  if (path.find('.') != std::string_view::npos) return {};
  std::vector<std::string> names;
  names.reserve(known.size());
  for (const std::string& one : known) names.push_back(one.substr(one.rfind('.') + 1));
  const std::vector<std::string> nearest = io::suggested_words(path, names);
  return nearest.empty() ? nearest : paths_ending_in(nearest.front(), known);
}

// The paths that may have been meant.
std::vector<std::string> suggested_paths(std::string_view path,
                                         const std::vector<std::string>& known) {
  std::vector<std::string> paths = paths_ending_in(path, known);
  if (paths.empty()) paths = paths_nearly_ending_in(path, known);
  return paths.empty() ? io::suggested_words(path, known) : paths;
}

std::string unknown_path_message(const std::vector<Setting>& settings, std::string_view path) {
  const std::vector<std::string> known =
      path.starts_with("teams.") ? full_paths(settings) : short_paths(settings);
  const std::vector<std::string> meant = suggested_paths(path, known);
  return fmt::format("unknown key '{}'{}", path,
                     meant.empty() ? "; expected a setting, such as b.handicap or match.half_s"
                                   : io::suggestion_text(meant));
}

// Returns the setting at a full path, including those inside another setting, or the preset of the
// branch.
std::optional<Setting> single_setting(const std::vector<Setting>& settings,
                                      const std::string& full) {
  const Setting* setting = find_setting(settings, full);
  if (setting == nullptr) setting = preset_of_branch(settings, full);
  if (setting != nullptr) return holds_others(*setting) ? preset_in(*setting) : *setting;
  const std::size_t dot = full.rfind('.');
  const Setting* holder = find_setting(settings, full.substr(0, dot));
  if (holder == nullptr || dot == std::string::npos) return std::nullopt;
  return setting_in(*holder, full.substr(dot + 1));
}

// The parameters of all strategies.
std::set<std::string> tunable_names() {
  std::set<std::string> names;
  for (const strategies::Entry& entry : strategies::all_strategies())
    for (const strategies::Tunable& tunable : entry.params) names.emplace(tunable.name);
  return names;
}

// A setting and the value given by the user.
struct Kept {
  Setting setting;
  SettingValue value;
};

std::vector<Kept> kept(const std::vector<Setting>& settings, const std::set<std::string>& given) {
  std::vector<Kept> all;
  for (const std::string& path : given) {
    const std::optional<Setting> setting = single_setting(settings, path);
    if (setting) all.push_back({*setting, current_value(*setting)});
  }
  return all;
}

// Creates the player of the team that a path such as "teams.b.players.3.handicap" names.
void make_player_in(TeamSettings& team, const std::string& prefix, std::string_view path) {
  const std::string players = prefix + "players.";
  if (!path.starts_with(players)) return;
  const std::string_view rest = path.substr(players.size());
  player_of(team.players, rest.substr(0, rest.find('.')));
}

}  // namespace

std::vector<std::string> full_paths(const std::vector<Setting>& settings) {
  std::vector<std::string> paths;
  for (const Setting& setting : settings) {
    if (!holds_others(setting)) paths.push_back(setting.path);
    for (const std::string& name : names_in(setting)) paths.push_back(setting.path + "." + name);
    if (!std::holds_alternative<Params*>(setting.target)) continue;
    for (const std::string& name : tunable_names()) paths.push_back(setting.path + "." + name);
  }
  return paths;
}

std::vector<std::string> short_paths(const std::vector<Setting>& settings) {
  std::vector<std::string> paths;
  for (const std::string& path : full_paths(settings)) paths.push_back(short_path(path));
  return paths;
}

std::vector<std::string> paths_ending_in(std::string_view end,
                                         const std::vector<std::string>& paths) {
  constexpr std::size_t kMost = 3;
  const std::string wanted = fmt::format(".{}", end);
  std::vector<std::string> found;
  for (const std::string& path : paths)
    if (found.size() < kMost && path.ends_with(wanted)) found.push_back(path);
  return found;
}

std::string_view branch_of(std::string_view path) { return path.substr(0, path.rfind('.')); }

bool sets_same_number(std::string_view path, std::string_view other) {
  const auto is_part = [](std::string_view part, std::string_view whole) {
    return whole.ends_with(".handicap") && part.ends_with("_factor") &&
           branch_of(part) == branch_of(whole);
  };
  const auto is_preset_of = [](std::string_view preset, std::string_view branch) {
    return preset == fmt::format("{}.{}", branch, kPresetName);
  };
  return path == other || is_part(path, other) || is_part(other, path) ||
         is_preset_of(path, other) || is_preset_of(other, path);
}

const Setting* find_setting(const std::vector<Setting>& settings, std::string_view path) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [path](const Setting& s) { return s.path == path; });
  return found == settings.end() ? nullptr : &*found;
}

const Setting* preset_of_branch(const std::vector<Setting>& settings, std::string_view path) {
  return find_setting(settings, fmt::format("{}.{}", path, kPresetName));
}

std::optional<Setting> preset_in(const Setting& setting) {
  return std::holds_alternative<ChangesOf>(setting.target) ? setting_in(setting, kPresetName)
                                                           : std::nullopt;
}

Setting setting_at(const std::vector<Setting>& settings, std::string_view path) {
  const std::optional<Setting> setting = single_setting(settings, full_path(path));
  if (setting) return *setting;
  throw std::invalid_argument(unknown_path_message(settings, path));
}

std::string full_path(std::string_view path) {
  const bool is_short = path.starts_with("a.") || path.starts_with("b.");
  return is_short ? fmt::format("teams.{}", path) : std::string(path);
}

std::string short_path(std::string_view path) {
  static constexpr std::string_view kTeams = "teams.";
  return std::string(path.starts_with(kTeams) ? path.substr(kTeams.size()) : path);
}

std::vector<std::string> names_in(const Setting& setting) {
  const auto* of = std::get_if<ChangesOf>(&setting.target);
  if (of == nullptr) return {};
  sim::RobotSpec robot;
  return names_below(settings_of(robot, ""), of->branch);
}

std::optional<Setting> setting_in(const Setting& setting, const std::string& name) {
  const std::string path = setting.path + "." + name;
  if (const auto* params = std::get_if<Params*>(&setting.target)) {
    return Setting{path, &(**params)[name], setting.range, {}, "", setting.about};
  }
  const auto* of = std::get_if<ChangesOf>(&setting.target);
  if (of == nullptr) return std::nullopt;
  sim::RobotSpec robot;
  const std::vector<Setting> settings = settings_of(robot, "");
  const Setting* changed = find_setting(settings, of->branch + "." + name);
  if (changed == nullptr) return std::nullopt;
  Setting change = *changed;
  change.path = path;
  change.target = Change{of->changes, changed->path, is_preset(*changed)};
  return change;
}

std::vector<std::string> names_below(const std::vector<Setting>& settings,
                                     std::string_view branch) {
  std::vector<std::string> names;
  for (const Setting& setting : settings) {
    std::string_view rest = setting.path;
    if (!branch.empty()) {
      if (!rest.starts_with(branch) || rest.size() <= branch.size() || rest[branch.size()] != '.') {
        continue;
      }
      rest.remove_prefix(branch.size() + 1);
    }
    std::string name(rest.substr(0, rest.find('.')));
    if (names.empty() || names.back() != name) names.push_back(std::move(name));
  }
  return names;
}

std::string unknown_key_message(std::string_view key, const std::vector<std::string>& known) {
  const std::string nearest = io::suggestion(key, known);
  return fmt::format("unknown key '{}'{} Known here: {}", key, nearest.empty() ? "." : nearest,
                     io::listed(known));
}

PlayerSettings& player_of(Players& players, std::string_view number) {
  const std::optional<int> n = io::whole_number_in(number);
  // Comparing the text rules out other spellings such as "03", which could name one robot twice.
  if (!n || *n < 0 || *n >= kMaxRobots || std::to_string(*n) != number) {
    throw std::invalid_argument(
        fmt::format("expected a robot's number from 0 to {}, found '{}'", kMaxRobots - 1, number));
  }
  return players[*n];
}

void set_given(const std::vector<Setting>& settings, const Setting& setting,
               const SettingValue& value, std::set<std::string>& given) {
  if (!is_preset(setting)) {
    set_value(setting, value);
    if (!is_alias(setting)) given.insert(setting.path);
    return;
  }
  // Settings that the user gave explicitly override a preset, regardless of their order: save them,
  // apply the preset, restore them.
  const std::vector<Kept> others = kept(settings, given);
  set_value(setting, value);
  for (const Kept& other : others) {
    if (current_value(other.setting) != other.value) set_value(other.setting, other.value);
  }
}

std::vector<Setting> settings_with(const SettingsRoot& root, std::string_view path) {
  const std::string full = full_path(path);
  if (root.team != nullptr) {
    make_player_in(*root.team, root.prefix, full);
    return settings_of(*root.team, root.game.types, root.prefix);
  }
  make_player_in(root.game.a, "teams.a.", full);
  make_player_in(root.game.b, "teams.b.", full);
  return settings_of(root.game);
}

SettingValue set_by_path(const SettingsRoot& root, std::string_view path, std::string_view text,
                         const std::filesystem::path& folder) {
  const std::vector<Setting> settings = settings_with(root, path);
  const Setting setting = setting_at(settings, path);
  SettingValue value =
      value_in(take_name(setting, std::string(text), folder, root.game.types), setting);
  set_given(settings, setting, value, root.game.given);
  return value;
}

void set_value_at(GameSettings& game, std::string_view path, const SettingValue& value) {
  const std::vector<Setting> settings = settings_with(game, path);
  set_given(settings, setting_at(settings, path), value, game.given);
}

std::string value_at(const GameSettings& game, std::string_view path) {
  GameSettings copy = game;
  return value_of(setting_at(settings_with(copy, path), path));
}

}  // namespace autoref::game
