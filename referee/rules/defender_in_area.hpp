// A robot other than the keeper must not touch the ball in play inside its own defence area: a
// penalty kick where it is entirely inside, and in the Laws of 2014 a yellow card and an indirect
// free kick where it is partly inside (law 12; 2026, Defender In Defense Area).
//
// A defender that is in contact with an opponent then may have been shoved there, and vision cannot
// tell who shoved: it is not blamed.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_defender_in_area(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kDefenderInAreaRule{
    RuleId::kDefenderInArea, {State::kRun}, find_defender_in_area};

}  // namespace autoref::referee
