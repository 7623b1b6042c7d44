#include "sim/dribbler_presets.hpp"

#include <array>
#include <stdexcept>

namespace autoref::sim {
namespace {

struct Preset {
  std::string_view name;
  DribblerParameters numbers;
};

// 100 N stop a ball of 46 g at 8 m/s, the fastest, within a sub-step of 1/240 s.
constexpr std::array kPresets = {Preset{"default", {}}, Preset{"perfect", {100.0, 10_mm, true}}};

}  // namespace

void apply_dribbler_preset(std::string_view name, DribblerParameters& dribbler) {
  std::string known;
  for (const Preset& preset : kPresets) {
    if (preset.name == name) {
      dribbler = preset.numbers;
      return;
    }
    known += (known.empty() ? "" : ", ") + std::string(preset.name);
  }
  throw std::invalid_argument("unknown dribbler preset '" + std::string(name) +
                              "'; known: " + known);
}

std::optional<std::string> dribbler_preset_of(const DribblerParameters& dribbler) {
  for (const Preset& preset : kPresets) {
    if (preset.numbers == dribbler) return std::string(preset.name);
  }
  return std::nullopt;
}

std::vector<std::string> dribbler_preset_names() {
  std::vector<std::string> names;
  names.reserve(kPresets.size());
  for (const Preset& preset : kPresets) names.emplace_back(preset.name);
  return names;
}

}  // namespace autoref::sim
