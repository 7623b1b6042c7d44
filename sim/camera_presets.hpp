// Kinds of vision and radio by name, so that results can be compared with other simulators'.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/configuration.hpp"

namespace autoref::sim {

// Sets vision, the radio's losses and the latency to those of the preset; leaves the rest alone.
// Throws std::invalid_argument that names the known presets.
void apply_camera_preset(std::string_view name, Configuration& configuration);

// The preset whose numbers these are; none where some were changed.
std::optional<std::string> camera_preset_of(const Configuration& configuration);

std::vector<std::string> camera_preset_names();

}  // namespace autoref::sim
