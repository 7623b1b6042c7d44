// A robot must not touch the ball in play while it is partly or entirely inside the opponents'
// defence area (2026, Attacker In Defense Area).
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_attacker_in_area(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kAttackerInAreaRule{
    RuleId::kAttackerInArea, {State::kRun}, find_attacker_in_area};

}  // namespace autoref::referee
