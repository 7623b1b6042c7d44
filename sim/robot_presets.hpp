// Presets of dribblers and kickers.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/configuration.hpp"

namespace autoref::sim {

// Each sets all parameters to the preset's, and throws std::invalid_argument, listing the known
// presets, if the name is unknown. Dribblers: `default` loses the ball in hard motion, `perfect`
// keeps it in any motion of its robot. Both: `rc2026` is as measured in games of 2026.
void apply_dribbler_preset(std::string_view name, DribblerParameters& dribbler);
void apply_kicker_preset(std::string_view name, KickerParameters& kicker);

// The preset with exactly these parameters; nullopt if there is none.
std::optional<std::string> dribbler_preset_of(const DribblerParameters& dribbler);
std::optional<std::string> kicker_preset_of(const KickerParameters& kicker);

std::vector<std::string> dribbler_preset_names();
std::vector<std::string> kicker_preset_names();

}  // namespace autoref::sim
