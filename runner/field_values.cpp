// Reading and writing single settings.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "runner/fields.hpp"
#include "runner/json.hpp"
#include "runner/robot_changes.hpp"
#include "runner/words.hpp"
#include "sim/ball_presets.hpp"
#include "sim/camera_presets.hpp"
#include "sim/dribbler_presets.hpp"

namespace autoref::runner {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

[[noreturn]] void refuse(const Setting& setting, std::string_view text) {
  throw std::invalid_argument(fmt::format("expected {}, found '{}'", expected_of(setting), text));
}

bool is_within(const Range& range, double value) {
  return (range.above_low ? value > range.low : value >= range.low) && value <= range.high;
}

template <typename Number>
Number checked(const Setting& setting, std::string_view text, std::optional<Number> number) {
  if (!number || !is_within(setting.range, static_cast<double>(*number))) refuse(setting, text);
  return *number;
}

// The place of `text` among the setting's words.
std::size_t index_of_word(const Setting& setting, std::string_view text) {
  const auto found = std::find(setting.words.begin(), setting.words.end(), text);
  if (found == setting.words.end()) refuse(setting, text);
  return static_cast<std::size_t>(found - setting.words.begin());
}

std::string range_text(const Setting& setting) {
  const Range& range = setting.range;
  const std::string unit = setting.unit.empty() ? "" : fmt::format(" {}", setting.unit);
  if (range.above_low) return fmt::format("above {} and at most {}{}", range.low, range.high, unit);
  return fmt::format("from {} to {}{}", range.low, range.high, unit);
}

std::string_view last_name_in(std::string_view path) { return path.substr(path.rfind('.') + 1); }

const Setting* find_setting(const std::vector<Setting>& settings, std::string_view path) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [path](const Setting& s) { return s.path == path; });
  return found == settings.end() ? nullptr : &*found;
}

std::string unknown_path_message(const std::vector<Setting>& settings, std::string_view path) {
  std::vector<std::string> known;
  known.reserve(settings.size());
  const auto add = [&](const std::string& full) {
    known.push_back(path.starts_with("teams.") ? full : short_path(full));
  };
  for (const Setting& setting : settings) {
    if (!holds_others(setting)) add(setting.path);
    for (const std::string& name : names_in(setting)) add(setting.path + "." + name);
  }
  return fmt::format("unknown key '{}'; did you mean '{}'?", path, nearest_word(path, known));
}

// The setting at a full or short path, also one that another holds.
Setting setting_at(const std::vector<Setting>& settings, std::string_view path) {
  const std::string full = full_path(path);
  const Setting* setting = find_setting(settings, full);
  if (setting != nullptr && !holds_others(*setting)) return *setting;
  const std::size_t dot = full.rfind('.');
  const Setting* holder = find_setting(settings, full.substr(0, dot));
  if (setting == nullptr && holder != nullptr && dot != std::string::npos) {
    if (const auto held = setting_in(*holder, full.substr(dot + 1))) return *held;
  }
  throw std::invalid_argument(unknown_path_message(settings, path));
}

// Makes the player that a path such as "b.players.3.handicap" speaks of, if it does.
void make_player_in(GameConfiguration& game, std::string_view path) {
  static constexpr std::string_view kPlayers = "teams.x.players.";
  const std::string full = full_path(path);
  for (TeamConfiguration* team : {&game.a, &game.b}) {
    const char letter = team == &game.a ? 'a' : 'b';
    if (!full.starts_with(fmt::format("teams.{}.players.", letter))) continue;
    const std::string rest = full.substr(kPlayers.size());
    player_of(team->players, rest.substr(0, rest.find('.')));
  }
}

std::string changes_text(const ChangesOf& of) {
  std::string text;
  for (const auto& [path, value] : *of.changes) {
    if (!path.starts_with(of.branch + ".")) continue;
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", last_name_in(path), value);
  }
  return "{" + text + "}";
}

std::string params_text(const Params& params) {
  std::string text;
  for (const auto& [name, value] : params) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", json_text(name), text_of(value));
  }
  return "{" + text + "}";
}

std::vector<std::string> names_of(const RobotTypes& types) {
  std::vector<std::string> names = {kNoType};
  for (const auto& [name, changes] : types) names.push_back(name);
  return names;
}

}  // namespace

std::string full_path(std::string_view path) {
  const bool is_short = path.starts_with("a.") || path.starts_with("b.");
  return is_short ? fmt::format("teams.{}", path) : std::string(path);
}

std::string short_path(std::string_view path) {
  static constexpr std::string_view kTeams = "teams.";
  return std::string(path.starts_with(kTeams) ? path.substr(kTeams.size()) : path);
}

bool is_number(const Setting& setting) {
  return setting.words.empty() && !holds_others(setting) &&
         !std::holds_alternative<TypeName>(setting.target);
}

bool is_alias(const Setting& setting) {
  return std::holds_alternative<BothFactors>(setting.target) ||
         std::holds_alternative<BallPreset>(setting.target) ||
         std::holds_alternative<CameraPreset>(setting.target) ||
         std::holds_alternative<DribblerPreset>(setting.target);
}

bool holds_others(const Setting& setting) {
  return std::holds_alternative<Params*>(setting.target) ||
         std::holds_alternative<ChangesOf>(setting.target) ||
         std::holds_alternative<Players*>(setting.target) ||
         std::holds_alternative<RobotTypes*>(setting.target);
}

std::vector<std::string> names_in(const Setting& setting) {
  const auto* of = std::get_if<ChangesOf>(&setting.target);
  if (of == nullptr) return {};
  sim::RobotSheet robot;
  return names_below(settings_of(robot, ""), of->branch);
}

std::optional<Setting> setting_in(const Setting& setting, const std::string& name) {
  const std::string path = setting.path + "." + name;
  if (const auto* params = std::get_if<Params*>(&setting.target)) {
    return Setting{path, &(**params)[name], setting.range, {}, "", setting.about};
  }
  const auto* of = std::get_if<ChangesOf>(&setting.target);
  if (of == nullptr) return std::nullopt;
  sim::RobotSheet robot;
  const std::vector<Setting> settings = settings_of(robot, "");
  const Setting* changed = find_setting(settings, of->branch + "." + name);
  if (changed == nullptr) return std::nullopt;
  Setting change = *changed;
  change.path = path;
  change.target = Change{of->changes, changed->path};
  return change;
}

std::string expected_of(const Setting& setting) {
  return std::visit(
      Overloaded{
          [&](double*) { return "a number " + range_text(setting); },
          [&](int*) { return "a whole number " + range_text(setting); },
          [&](std::uint64_t*) { return std::string("a whole number from 0 to 2^64 - 1"); },
          [&](BothFactors) { return "a number " + range_text(setting); },
          [&](TypeName type) {
            return "a file such as robots/slow.yaml, or one of " + listed(names_of(*type.types));
          },
          [&](const Change&) {
            return setting.words.empty() ? "a number " + range_text(setting)
                                         : "one of " + listed(setting.words);
          },
          [&](const ChangesOf&) { return std::string("numbers by name"); },
          [&](Params*) { return std::string("numbers by name"); },
          [&](Players*) { return std::string("robots by number"); },
          [&](RobotTypes*) { return std::string("types by name"); },
          [&](auto) {
            return (setting.words.size() == 1 ? "" : "one of ") + listed(setting.words);
          },
      },
      setting.target);
}

void assign(const Setting& setting, std::string_view text) {
  const auto number = [&] { return checked(setting, text, number_in(text)); };
  std::visit(
      Overloaded{
          [&](double* value) { *value = number(); },
          [&](int* value) { *value = checked(setting, text, whole_number_in(text)); },
          [&](std::uint64_t* value) { *value = checked(setting, text, seed_in(text)); },
          [&](BothFactors both) { *both.speed = *both.acceleration = number(); },
          [&](TypeName type) {
            if (text != kNoType && !type.types->contains(std::string(text))) {
              refuse(setting, text);
            }
            *type.name = text;
          },
          [&](const Change& change) { assign_change(change, text); },
          [&](const ChangesOf&) { refuse(setting, text); },
          [&](Params*) { refuse(setting, text); },
          [&](Players*) { refuse(setting, text); },
          [&](RobotTypes*) { refuse(setting, text); },
          [&](DribblerPreset preset) {
            sim::apply_dribbler_preset(setting.words[index_of_word(setting, text)],
                                       *preset.dribbler);
          },
          [&](BallPreset preset) {
            sim::apply_ball_preset(setting.words[index_of_word(setting, text)], *preset.ball);
          },
          [&](CameraPreset preset) {
            sim::apply_camera_preset(setting.words[index_of_word(setting, text)], *preset.sim);
          },
          [&](std::string* value) { *value = setting.words[index_of_word(setting, text)]; },
          [&](auto* value) {
            using Enumeration = std::remove_pointer_t<decltype(value)>;
            *value = static_cast<Enumeration>(index_of_word(setting, text));
          },
      },
      setting.target);
}

std::string value_of(const Setting& setting) {
  return std::visit(
      Overloaded{
          [](double* value) { return text_of(*value); },
          [](int* value) { return std::to_string(*value); },
          [](std::uint64_t* value) { return std::to_string(*value); },
          [](std::string* value) { return *value; },
          [](BothFactors both) { return text_of(*both.speed); },
          [](BallPreset preset) { return sim::ball_preset_of(*preset.ball).value_or("other"); },
          [](CameraPreset preset) { return sim::camera_preset_of(*preset.sim).value_or("other"); },
          [](DribblerPreset preset) {
            return sim::dribbler_preset_of(*preset.dribbler).value_or("other");
          },
          [](TypeName type) { return *type.name; },
          [](const Change& change) { return changed_value(change); },
          [](const ChangesOf& of) { return changes_text(of); },
          [](Params* params) { return params_text(*params); },
          [](Players*) { return std::string("{}"); },
          [](RobotTypes*) { return std::string("{}"); },
          [&](auto* value) { return setting.words[static_cast<std::size_t>(*value)]; },
      },
      setting.target);
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
  return fmt::format("unknown key '{}'; did you mean '{}'? Known here: {}", key,
                     nearest_word(key, known), listed(known));
}

PlayerConfiguration& player_of(Players& players, std::string_view number) {
  const std::optional<int> n = whole_number_in(number);
  if (!n || *n < 0 || *n >= kMaxRobots || std::to_string(*n) != number) {
    throw std::invalid_argument(
        fmt::format("expected a robot's number from 0 to {}, found '{}'", kMaxRobots - 1, number));
  }
  return players[*n];
}

void set_by_path(GameConfiguration& game, std::string_view path, std::string_view text) {
  make_player_in(game, path);
  assign(setting_at(settings_of(game), path), text);
}

std::string value_at(const GameConfiguration& game, std::string_view path) {
  GameConfiguration copy = game;
  make_player_in(copy, path);
  return value_of(setting_at(settings_of(copy), path));
}

}  // namespace autoref::runner
