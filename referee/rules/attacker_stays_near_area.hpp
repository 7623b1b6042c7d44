// During stop and free kicks robots keep 0.2 m away from the opponents' defence area, and have 2 s
// to get away from it (2026, Attacker Too Close To Defense Area): a foul that is noted, once per
// robot and stop. The free kick belongs to the stop before it.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_attacker_stays_near_area(RefereeState& state,
                                                     const RefereeInput& input);

inline constexpr Rule kAttackerStaysNearAreaRule{
    RuleId::kAttackerNearArea, {State::kRun, State::kWaitStop}, find_attacker_stays_near_area};

}  // namespace autoref::referee
