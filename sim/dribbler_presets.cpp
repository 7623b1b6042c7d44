#include "sim/dribbler_presets.hpp"

#include <array>

#include "sim/presets.hpp"

namespace autoref::sim {
namespace {

struct DribblerPreset {
  std::string_view name;
  DribblerParameters numbers;
};

// 100 N stop a ball of 46 g at 8 m/s, the maximum, within a sub-step of 1/240 s. The robots of 2026
// lose the ball when they brake at 3 m/s^2: on the carpet, the ball `rc2026` then needs a pull of
// (3 + 0.22) m/s^2 * 46 g / 0.66.
constexpr std::array kDribblerPresets = {DribblerPreset{"default", {}},
                                         DribblerPreset{"perfect", {100.0, 10_mm, true}},
                                         DribblerPreset{"rc2026", {0.225}}};

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
