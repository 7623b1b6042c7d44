// Dribbler presets.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/configuration.hpp"

namespace autoref::sim {

// Sets all parameters to the preset's: `default` loses the ball in hard motion, `perfect` keeps it
// in any motion of its robot. Throws std::invalid_argument, listing the known presets, if the name
// is unknown.
void apply_dribbler_preset(std::string_view name, DribblerParameters& dribbler);

// The preset with exactly these parameters; nullopt if there is none.
std::optional<std::string> dribbler_preset_of(const DribblerParameters& dribbler);

std::vector<std::string> dribbler_preset_names();

}  // namespace autoref::sim
