// Opponents keep 500 mm away from the ball until it is in play (Laws 8 and 13; 2026, Defender Too
// Close To Ball). Penalty kicks have places of their own.
//
// By the Laws the restart is taken again; whoever was too near before then, too, sees a yellow
// card. What counts are the robots in the last frame before the ball was in play: one that
// starts when it sees the kick is not at fault. In 2026 it is a foul that is noted, once per robot
// and restart, when it lasts longer than 2 s, and the time for the kick begins anew.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_restart_distance(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kRestartDistanceRule{
    RuleId::kRestartDistance, {State::kRun}, find_restart_distance};

}  // namespace autoref::referee
