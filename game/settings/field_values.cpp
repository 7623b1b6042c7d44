// Reads and writes the values of settings.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "game/settings/command_text.hpp"
#include "game/settings/fields.hpp"
#include "game/settings/game_settings.hpp"
#include "game/settings/measured_presets.hpp"
#include "game/settings/robot_types.hpp"
#include "io/words.hpp"
#include "io/yaml_text.hpp"
#include "sim/presets.hpp"

namespace autoref::game {
namespace {

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};
template <typename... Cases>
Overloaded(Cases...) -> Overloaded<Cases...>;

[[noreturn]] void refuse(const Setting& setting, std::string_view text) {
  throw std::invalid_argument(fmt::format("expected {}, found '{}'{}", expected_of(setting), text,
                                          io::suggestion(text, setting.allowed_words)));
}

template <typename Number>
Number checked(const Setting& setting, std::string_view text, std::optional<Number> number) {
  if (!number || !setting.range.contains(static_cast<double>(*number))) refuse(setting, text);
  return *number;
}

bool is_measured(const MeasuredPresets* presets, std::string_view name) {
  return presets != nullptr && presets->contains(std::string(name));
}

std::string word_in(const Setting& setting, std::string_view text) {
  const auto found = std::find(setting.allowed_words.begin(), setting.allowed_words.end(), text);
  if (found == setting.allowed_words.end()) refuse(setting, text);
  return *found;
}

std::string_view last_name_in(std::string_view path) { return path.substr(path.rfind('.') + 1); }

std::string changes_text(const ChangesOf& of) {
  std::string text;
  for (const auto& [path, value] : *of.changes) {
    if (!path.starts_with(of.branch + ".")) continue;
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", last_name_in(path), spelt(value));
  }
  return "{" + text + "}";
}

std::string params_text(const Params& params) {
  std::string text;
  for (const auto& [name, value] : params) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : ", ", io::quoted_scalar(name),
                        io::text_of(value));
  }
  return "{" + text + "}";
}

bool is_text(const Setting& setting) {
  return std::holds_alternative<FreeText>(setting.target) ||
         std::holds_alternative<CommandWords>(setting.target);
}

// "a file such as robots/slow.yaml, or one of none, fast".
template <typename Content>
std::string file_or_name(const char* example, std::vector<std::string> names,
                         const std::map<std::string, Content>& from_files) {
  for (const auto& [name, content] : from_files) names.push_back(name);
  return fmt::format("a file such as {}, or one of {}", example, io::listed(names));
}

std::string expected_preset(const Setting& setting, const MeasuredPresets* measured) {
  if (measured == nullptr) return "one of " + io::listed(setting.allowed_words);
  return file_or_name("measured.yaml", setting.allowed_words, *measured);
}

}  // namespace

bool is_number(const Setting& setting) {
  return setting.allowed_words.empty() && !holds_others(setting) && !is_text(setting) &&
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
         std::holds_alternative<DribblerPreset>(setting.target) ||
         std::holds_alternative<KickerPreset>(setting.target);
}

bool holds_others(const Setting& setting) {
  return std::holds_alternative<Params*>(setting.target) ||
         std::holds_alternative<ChangesOf>(setting.target) ||
         std::holds_alternative<Players*>(setting.target) ||
         std::holds_alternative<RobotTypes*>(setting.target) ||
         std::holds_alternative<MeasuredPresets*>(setting.target);
}

std::string expected_of(const Setting& setting) {
  return std::visit(
      Overloaded{
          [&](double*) { return "a number " + text_of(setting.range, setting.unit); },
          [&](int*) { return "a whole number " + text_of(setting.range, setting.unit); },
          [&](std::uint64_t*) { return std::string("a whole number from 0 to 2^64 - 1"); },
          [&](BothFactors) { return "a number " + text_of(setting.range, setting.unit); },
          [&](TypeName type) { return file_or_name("robots/slow.yaml", {kNoType}, *type.types); },
          [&](BallPreset preset) { return expected_preset(setting, preset.measured); },
          [&](CameraPreset preset) { return expected_preset(setting, preset.measured); },
          [&](FreeText) { return std::string("text"); },
          [&](CommandWords) {
            return std::string("a command such as [python3, my_team.py] or 'python3 my_team.py'");
          },
          [&](const Change&) {
            return setting.allowed_words.empty()
                       ? "a number " + text_of(setting.range, setting.unit)
                       : "one of " + io::listed(setting.allowed_words);
          },
          [&](const ChangesOf&) { return std::string("numbers by name"); },
          [&](Params*) { return std::string("numbers by name"); },
          [&](Players*) { return std::string("robots by number"); },
          [&](RobotTypes*) { return std::string("types by name"); },
          [&](MeasuredPresets*) { return std::string("presets by name"); },
          [&](auto) {
            return (setting.allowed_words.size() == 1 ? "" : "one of ") +
                   io::listed(setting.allowed_words);
          },
      },
      setting.target);
}

SettingValue value_in(std::string_view text, const Setting& setting) {
  const auto number = [&] { return checked(setting, text, io::number_in(text)); };
  const auto word = [&] { return word_in(setting, text); };
  const auto none = [&]() -> SettingValue { refuse(setting, text); };
  const auto preset = [&](const MeasuredPresets* measured) -> SettingValue {
    return is_measured(measured, text) ? std::string(text) : word();
  };
  return std::visit(
      Overloaded{
          [&](double*) -> SettingValue { return number(); },
          [&](int*) -> SettingValue { return checked(setting, text, io::whole_number_in(text)); },
          [&](std::uint64_t*) -> SettingValue { return checked(setting, text, io::seed_in(text)); },
          [&](BothFactors) -> SettingValue { return number(); },
          [&](const TypeName& type) -> SettingValue {
            std::string name(text);
            return name == kNoType || type.types->contains(name) ? name : none();
          },
          [&](FreeText) -> SettingValue { return std::string(text); },
          [&](CommandWords) -> SettingValue { return text_of_command(words_of_command(text)); },
          [&](const Change&) -> SettingValue {
            if (setting.allowed_words.empty()) return number();
            return word();
          },
          [&](const ChangesOf&) { return none(); },
          [&](Params*) { return none(); },
          [&](Players*) { return none(); },
          [&](RobotTypes*) { return none(); },
          [&](MeasuredPresets*) { return none(); },
          [&](BallPreset ball) { return preset(ball.measured); },
          [&](CameraPreset camera) { return preset(camera.measured); },
          [&](const auto&) -> SettingValue { return word(); },
      },
      setting.target);
}

void set_value(const Setting& setting, const SettingValue& value) {
  const auto word = [&value]() -> const std::string& { return std::get<std::string>(value); };
  const auto none = [&setting] { throw std::logic_error(setting.path + " has no value"); };
  std::visit(
      Overloaded{
          [&](double* number) { *number = std::get<double>(value); },
          [&](int* number) { *number = std::get<int>(value); },
          [&](std::uint64_t* number) { *number = std::get<std::uint64_t>(value); },
          [&](BothFactors both) { *both.speed = *both.acceleration = std::get<double>(value); },
          [&](const TypeName& type) { *type.name = word(); },
          [&](FreeText free) { *free.text = word(); },
          [&](CommandWords command) { *command.words = words_of_command(word()); },
          [&](const Change& change) { set_change(change, value); },
          [&](const ChangesOf&) { none(); },
          [&](Params*) { none(); },
          [&](Players*) { none(); },
          [&](RobotTypes*) { none(); },
          [&](MeasuredPresets*) { none(); },
          [&](DribblerPreset preset) { sim::apply_dribbler_preset(word(), *preset.dribbler); },
          [&](KickerPreset preset) { sim::apply_kicker_preset(word(), *preset.kicker); },
          [&](BallPreset preset) { apply_preset(word(), preset); },
          [&](CameraPreset preset) { apply_preset(word(), preset); },
          [&](RulesChoice choice) { choose_rules(word(), *choice.game); },
          [&](std::string* text) { *text = word(); },
          [&](bool* flag) { *flag = word() == kYes; },
          [&](EnumerationName one) { one.set(one.value, word()); },
      },
      setting.target);
}

void assign(const Setting& setting, std::string_view text) {
  set_value(setting, value_in(text, setting));
}

SettingValue current_value(const Setting& setting) {
  const auto none = [&setting]() -> SettingValue {
    throw std::logic_error(setting.path + " has no value");
  };
  return std::visit(
      Overloaded{
          [](double* number) -> SettingValue { return *number; },
          [](int* number) -> SettingValue { return *number; },
          [](std::uint64_t* number) -> SettingValue { return *number; },
          [](std::string* word) -> SettingValue { return *word; },
          [](BothFactors both) -> SettingValue { return *both.speed; },
          [](BallPreset preset) -> SettingValue {
            return sim::ball_preset_of(*preset.ball).value_or("other");
          },
          [](CameraPreset preset) -> SettingValue {
            return sim::camera_preset_of(*preset.sim).value_or("other");
          },
          [](DribblerPreset preset) -> SettingValue {
            return sim::dribbler_preset_of(*preset.dribbler).value_or("other");
          },
          [](KickerPreset preset) -> SettingValue {
            return sim::kicker_preset_of(*preset.kicker).value_or("other");
          },
          [](RulesChoice choice) -> SettingValue { return choice.game->match.rules.name; },
          [](const TypeName& type) -> SettingValue { return *type.name; },
          [](FreeText free) -> SettingValue { return *free.text; },
          [](CommandWords command) -> SettingValue { return text_of_command(*command.words); },
          [](const Change& change) { return changed_value(change); },
          [&](const ChangesOf&) { return none(); },
          [&](Params*) { return none(); },
          [&](Players*) { return none(); },
          [&](RobotTypes*) { return none(); },
          [&](MeasuredPresets*) { return none(); },
          [](bool* flag) -> SettingValue { return std::string(*flag ? kYes : kNo); },
          [](EnumerationName one) -> SettingValue { return std::string(one.name(one.value)); },
      },
      setting.target);
}

std::string value_of(const Setting& setting) {
  if (const auto* of = std::get_if<ChangesOf>(&setting.target)) return changes_text(*of);
  if (const auto* params = std::get_if<Params*>(&setting.target)) return params_text(**params);
  if (is_text(setting)) return io::quoted_scalar(spelt(current_value(setting)));
  return holds_others(setting) ? "{}" : spelt(current_value(setting));
}

}  // namespace autoref::game
