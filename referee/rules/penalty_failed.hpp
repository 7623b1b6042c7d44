// A penalty kick that has failed (penalty_outcome.hpp) is over: goal kick for the defenders (2026,
// Penalty Kick).
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_penalty_failed(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kPenaltyFailedRule{
    RuleId::kPenaltyFailed, {State::kRun}, find_penalty_failed};

}  // namespace autoref::referee
