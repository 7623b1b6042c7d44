// Robots are slow while play is stopped: 1 m/s (Laws 2014, single size) or 1.5 m/s, after 2 s of
// grace. Who is faster for 0.1 s is told once in a stop.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_stop_speed(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kStopSpeedRule{RuleId::kStopSpeed, {State::kWaitStop}, find_stop_speed};

}  // namespace autoref::referee
