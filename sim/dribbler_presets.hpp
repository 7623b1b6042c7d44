// Dribblers by name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/configuration.hpp"

namespace autoref::sim {

// Sets all numbers to those of the preset: `default` loses the ball in hard motion, `perfect` keeps
// it in every motion of its robot. Throws std::invalid_argument that names the known presets.
void apply_dribbler_preset(std::string_view name, DribblerParameters& dribbler);

// The preset whose numbers these are; none where some were changed.
std::optional<std::string> dribbler_preset_of(const DribblerParameters& dribbler);

std::vector<std::string> dribbler_preset_names();

}  // namespace autoref::sim
