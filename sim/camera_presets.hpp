// Vision and radio presets, for comparing results with other simulators.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/configuration.hpp"

namespace autoref::sim {

// Sets vision, frame rate, radio losses and latency to the preset's; leaves the rest unchanged.
// Throws std::invalid_argument, listing the known presets, if the name is unknown.
void apply_camera_preset(std::string_view name, Configuration& configuration);

// The preset with exactly these parameters; nullopt if there is none.
std::optional<std::string> camera_preset_of(const Configuration& configuration);

std::vector<std::string> camera_preset_names();

}  // namespace autoref::sim
