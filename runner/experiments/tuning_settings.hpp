// The settings of a tuning, for reading and writing.
#pragma once

#include <string>
#include <vector>

#include "runner/experiments/tuning.hpp"
#include "runner/settings/fields.hpp"

namespace autoref::runner {

// "iterations", "pairs", "gain" and so on; without the teams and parameters.
std::vector<Setting> settings_of(Tuning& tuning);

// "tune.pass_risk.from" and so on.
std::vector<Setting> settings_of(TunedParameter& parameter);

// "weights.zone", which must be in `weights`.
std::vector<Setting> weight_settings_of(Tuning& tuning);

}  // namespace autoref::runner
