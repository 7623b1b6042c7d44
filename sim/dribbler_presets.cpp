#include "sim/dribbler_presets.hpp"

#include <array>

#include "sim/presets.hpp"

namespace autoref::sim {
namespace {

struct DribblerPreset {
  std::string_view name;
  DribblerParameters numbers;
};

// 100 N stop a ball of 46 g at 8 m/s, the maximum, within a sub-step of 1/240 s.
constexpr std::array kDribblerPresets = {DribblerPreset{"default", {}},
                                         DribblerPreset{"perfect", {100.0, 10_mm, true}}};

}  // namespace

void apply_dribbler_preset(std::string_view name, DribblerParameters& dribbler) {
  dribbler = preset_called(name, kDribblerPresets, "dribbler").numbers;
}

std::optional<std::string> dribbler_preset_of(const DribblerParameters& dribbler) {
  return name_of_preset(kDribblerPresets,
                        [&](const DribblerPreset& preset) { return preset.numbers == dribbler; });
}

std::vector<std::string> dribbler_preset_names() { return names_of(kDribblerPresets); }

}  // namespace autoref::sim
