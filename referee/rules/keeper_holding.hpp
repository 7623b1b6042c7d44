// The keeper holds the ball inside its own defence area for longer than 15 s (Laws 12). By the
// rules of 2026 the ball must not stay inside a defence area for longer than 10 s (Division A: 5
// s), whether the keeper has it or not: nobody else may play it there.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_keeper_holding(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kKeeperHoldingRule{
    RuleId::kKeeperHolding, {State::kRun}, find_keeper_holding};

}  // namespace autoref::referee
