// Helpers to write down lists of settings.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "game/settings/fields.hpp"
#include "soccer/named.hpp"
#include "soccer/parameters.hpp"

namespace autoref::game {

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

  // All parameters of `of`, in each branch after its preset.
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

}  // namespace autoref::game
