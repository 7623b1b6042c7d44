// Reads and writes the values of settings.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "runner/io/words.hpp"
#include "runner/io/yaml_scalar.hpp"
#include "runner/settings/fields.hpp"
#include "runner/settings/resolved.hpp"
#include "runner/settings/robot_changes.hpp"
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
  throw std::invalid_argument(fmt::format("expected {}, found '{}'{}", expected_of(setting), text,
                                          suggestion(text, setting.words)));
}

bool is_within(const Range& range, double value) {
  return (range.above_low ? value > range.low : value >= range.low) && value <= range.high;
}

template <typename Number>
Number checked(const Setting& setting, std::string_view text, std::optional<Number> number) {
  if (!number || !is_within(setting.range, static_cast<double>(*number))) refuse(setting, text);
  return *number;
}

// Index of `text` among the setting's words.
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
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", quoted_scalar(name), text_of(value));
  }
  return "{" + text + "}";
}

std::vector<std::string> names_of(const RobotTypes& types) {
  std::vector<std::string> names = {kNoType};
  for (const auto& [name, changes] : types) names.push_back(name);
  return names;
}

}  // namespace

bool is_number(const Setting& setting) {
  return setting.words.empty() && !holds_others(setting) &&
         !std::holds_alternative<TypeName>(setting.target);
}

bool is_alias(const Setting& setting) {
  return std::holds_alternative<BothFactors>(setting.target) ||
         (is_preset(setting) && !std::holds_alternative<RulesChoice>(setting.target));
}

bool is_preset(const Setting& setting) {
  if (const auto* change = std::get_if<Change>(&setting.target)) return change->is_preset;
  return std::holds_alternative<RulesChoice>(setting.target) ||
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
          [&](RulesChoice choice) {
            choose_rules(setting.words[index_of_word(setting, text)], *choice.game);
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
          [](RulesChoice choice) { return choice.game->match.rules; },
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

}  // namespace autoref::runner
