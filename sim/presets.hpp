// Lookup in tables of presets: any range of structs with a `name`.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace autoref::sim {

template <typename Presets>
std::vector<std::string> names_of(const Presets& presets) {
  std::vector<std::string> names;
  names.reserve(presets.size());
  for (const auto& preset : presets) names.emplace_back(preset.name);
  return names;
}

// Finds a preset by name. Throws std::invalid_argument that lists the known presets; `kind` names
// what they apply to.
template <typename Presets>
const auto& preset_called(std::string_view name, const Presets& presets, const std::string& kind) {
  std::string known;
  for (const auto& preset : presets) {
    if (preset.name == name) return preset;
    known += (known.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw std::invalid_argument("unknown " + kind + " preset '" + std::string(name) +
                              "'; known: " + known);
}

// The name of the first preset that satisfies `is_it`.
template <typename Presets, typename Is>
std::optional<std::string> name_of_preset(const Presets& presets, Is is_it) {
  for (const auto& preset : presets) {
    if (is_it(preset)) return std::string(preset.name);
  }
  return std::nullopt;
}

}  // namespace autoref::sim
