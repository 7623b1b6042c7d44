// Reading and writing single settings.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "runner/fields.hpp"
#include "runner/words.hpp"
#include "sim/ball_presets.hpp"
#include "sim/camera_presets.hpp"

namespace autoref::runner {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

using Params = std::map<std::string, double>;

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

// Splits "teams.a.params.line_m" into the setting's path and the parameter's name.
std::pair<std::string, std::string> split_parameter(const std::string& path) {
  static constexpr std::string_view kPart = ".params.";
  const std::size_t at = path.find(kPart);
  if (at == std::string::npos) return {path, ""};
  return {path.substr(0, at + kPart.size() - 1), path.substr(at + kPart.size())};
}

const Setting* find_setting(const std::vector<Setting>& settings, std::string_view path) {
  const auto found = std::find_if(settings.begin(), settings.end(),
                                  [path](const Setting& s) { return s.path == path; });
  return found == settings.end() ? nullptr : &*found;
}

Setting setting_of_parameter(const Setting& params, const std::string& name) {
  Params& values = *std::get<Params*>(params.target);
  return {params.path + "." + name, &values[name], params.range, {}, "", params.about};
}

std::string unknown_path_message(const std::vector<Setting>& settings, std::string_view path) {
  std::vector<std::string> known;
  known.reserve(settings.size());
  for (const Setting& setting : settings) {
    known.push_back(path.starts_with("teams.") ? setting.path : short_path(setting.path));
  }
  return fmt::format("unknown key '{}'; did you mean '{}'?", path, nearest_word(path, known));
}

// The setting at a full or short path, a team's parameter included.
Setting setting_at(const std::vector<Setting>& settings, std::string_view path) {
  const auto [of, parameter] = split_parameter(full_path(path));
  const Setting* setting = find_setting(settings, of);
  const bool is_map = setting != nullptr && std::holds_alternative<Params*>(setting->target);
  if (setting == nullptr || is_map == parameter.empty()) {
    throw std::invalid_argument(unknown_path_message(settings, path));
  }
  return is_map ? setting_of_parameter(*setting, parameter) : *setting;
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
  return setting.words.empty() && !std::holds_alternative<Params*>(setting.target);
}

bool is_alias(const Setting& setting) {
  return std::holds_alternative<BothFactors>(setting.target) ||
         std::holds_alternative<BallPreset>(setting.target) ||
         std::holds_alternative<CameraPreset>(setting.target);
}

std::string expected_of(const Setting& setting) {
  return std::visit(
      Overloaded{
          [&](double*) { return "a number " + range_text(setting); },
          [&](int*) { return "a whole number " + range_text(setting); },
          [&](std::uint64_t*) { return std::string("a whole number from 0 to 2^64 - 1"); },
          [&](BothFactors) { return "a number " + range_text(setting); },
          [&](Params*) { return std::string("numbers by name"); },
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
          [&](Params*) { refuse(setting, text); },
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
          [](Params*) { return std::string(); },
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

void set_by_path(GameConfiguration& game, std::string_view path, std::string_view text) {
  assign(setting_at(settings_of(game), path), text);
}

std::string value_at(const GameConfiguration& game, std::string_view path) {
  GameConfiguration copy = game;
  return value_of(setting_at(settings_of(copy), path));
}

}  // namespace autoref::runner
