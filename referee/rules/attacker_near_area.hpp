// "Each robot must be at least 200 mm away from the opposing team's defense area, or an indirect
// free kick is awarded to the opposing team" (paper, section 4.2).
//
// Deviation D9: judged when the ball enters play from a restart, as in the Laws; always in force it
// would forbid attacking. The kicking side is judged first, so that the order of the sides never
// decides between two offenders.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_attacker_near_area(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kAttackerNearAreaRule{
    RuleId::kAttackerNearArea, {State::kRun}, find_attacker_near_area};

}  // namespace autoref::referee
