// Builds lists of settings, and reads YAML mappings with keys that are not settings of a game.
#pragma once

#include <fmt/format.h>
#include <algorithm>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "game/settings/fields.hpp"
#include "game/settings/settings_reader.hpp"
#include "game/settings/yaml.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"

namespace autoref::game {

// Reads and sets an enumeration by name.
template <HasNames Enumeration>
EnumerationName enumeration_name(Enumeration& value) {
  return {&value,
          [](const void* of) { return autoref::name_of(*static_cast<const Enumeration*>(of)); },
          [](void* of, std::string_view name) {
            *static_cast<Enumeration*>(of) = find_named<Enumeration>(name).value();
          }};
}

// The setting at `path` for a parameter that is a number, yes or no, or an enumeration.
template <typename Value>
Setting setting_of(std::string path, Value& value, const Parameter& parameter) {
  if constexpr (HasNames<Value>) {
    return {std::move(path), enumeration_name(value), {}, all_names<Value>(), "", parameter.about};
  } else if constexpr (std::is_same_v<Value, bool>) {
    return {std::move(path), &value, {}, {kNo, kYes}, "", parameter.about};
  } else {
    const std::string_view unit = unit_of(parameter.name);
    return {std::move(path), &value, parameter.range, {}, unit, parameter.about};
  }
}

class Branch;

// The preset that sets all parameters of a branch, or several of them.
void list_preset(sim::Configuration& sim, Branch& to);
void list_preset(sim::BallParameters& ball, Branch& to);
void list_preset(sim::KickerParameters& kicker, Branch& to);
void list_preset(sim::DribblerParameters& dribbler, Branch& to);

// Collects the settings of one branch.
class Branch {
 public:
  Branch(std::vector<Setting>& list, std::string path) : list_(list), path_(std::move(path)) {}

  template <typename Value>
  void parameter(Value& value, const Parameter& parameter) {
    list_.push_back(setting_of(path_ + std::string(parameter.name), value, parameter));
  }

  // Adds all parameters of `of`. In each branch, the preset comes first.
  template <HasParameters Of>
  void parameters(Of& of) {
    if constexpr (requires(Branch to) { list_preset(of, to); }) list_preset(of, *this);
    Of::visit(of, [this](auto& value, const Parameter& about) {
      if constexpr (HasParameters<std::remove_reference_t<decltype(value)>>) {
        below(std::string(about.name)).parameters(value);
      } else {
        parameter(value, about);
      }
    });
  }

  void add(std::string_view name, Target target, Range range, std::string_view about) {
    list_.push_back({path_ + std::string(name), std::move(target), range, {}, "", about});
  }

  void word(std::string_view name, Target target, std::vector<std::string> words,
            std::string_view about) {
    list_.push_back(
        {path_ + std::string(name), std::move(target), {}, std::move(words), "", about});
  }

  Branch below(const std::string& name) const { return {list_, path_ + name + "."}; }

 private:
  std::vector<Setting>& list_;
  std::string path_;
};

// A mapping in which each key must be known and given at most once. All reading functions throw
// InputError.
class Mapping {
 public:
  Mapping(const YamlFile& file, const YamlEntry& entry, std::string path,
          const std::vector<std::string>& known)
      : file_(file), path_(std::move(path)), entries_(file.entries(entry, path_, known)) {
    for (const YamlEntry& key : entries_) {
      if (std::find(known.begin(), known.end(), key.key) != known.end()) continue;
      file_.refuse(key.location, path_, unknown_key_message(key.key, known));
    }
  }

  const YamlEntry* find(std::string_view key) const { return find_entry(entries_, key); }

  // These functions leave the value unchanged if the key is not given.
  void number(std::string_view key, double& value, Range range, std::string_view unit) const {
    read(key, {path_to(key), &value, range, {}, unit, ""});
  }
  // Reads all parameters of `of`.
  template <HasParameters Of>
  void parameters(Of& of) const {
    Of::visit(of, [this](auto& value, const Parameter& about) {
      read(about.name, setting_of(path_to(about.name), value, about));
    });
  }
  void word(std::string_view key, std::string& value, std::vector<std::string> words) const {
    read(key, {path_to(key), &value, {}, std::move(words), "", ""});
  }
  void yes_or_no(std::string_view key, bool& value) const {
    std::string text = value ? "true" : "false";
    word(key, text, {"true", "false"});
    value = text == "true";
  }

  std::string path_to(std::string_view key) const { return fmt::format("{}.{}", path_, key); }

 private:
  void read(std::string_view key, const Setting& setting) const {
    const YamlEntry* entry = find(key);
    if (entry != nullptr) assign_entry(file_, *entry, setting);
  }

  const YamlFile& file_;
  std::string path_;
  std::vector<YamlEntry> entries_;
};

}  // namespace autoref::game
