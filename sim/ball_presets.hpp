// The ball models of the league's simulators, for comparing results with theirs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/configuration.hpp"

namespace autoref::sim {

// Sets the parameters of the two-phase model and of the bounces to the preset's; leaves the others
// (rest_mps, rolls_below_hop_m, net_mps2) unchanged. Throws std::invalid_argument, listing the
// known presets, if the name is unknown.
void apply_ball_preset(std::string_view name, BallParameters& ball);

// The preset with exactly these parameters; nullopt if there is none.
std::optional<std::string> ball_preset_of(const BallParameters& ball);

std::vector<std::string> ball_preset_names();

}  // namespace autoref::sim
