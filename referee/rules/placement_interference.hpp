// While the ball is on its way to its place, robots of the side that does not take the restart keep
// 0.5 m away from the line between both; 2 s of grace (2026). Each robot is told once in a stop.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_placement_interference(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kPlacementInterferenceRule{
    RuleId::kPlacementInterference, {State::kWaitStop}, find_placement_interference};

}  // namespace autoref::referee
