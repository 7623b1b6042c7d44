// How the league's simulators model the ball, so that results can be compared with theirs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/configuration.hpp"

namespace autoref::sim {

// Sets the numbers of the two-phase model and of the hops to those of the preset; leaves the
// others (rest_mps, rolls_below_hop_m, net_mps2) alone. Throws std::invalid_argument that names
// the known presets.
void apply_ball_preset(std::string_view name, BallParameters& ball);

// The preset whose numbers these are; none where some were changed.
std::optional<std::string> ball_preset_of(const BallParameters& ball);

std::vector<std::string> ball_preset_names();

}  // namespace autoref::sim
