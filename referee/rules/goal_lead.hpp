// Early termination: the game ends once a side has scored 10 goals and leads by more than one
// (2026). Found right after the goal, so that its command has gone out.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_goal_lead(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kGoalLeadRule{RuleId::kGoalLead, {State::kDelayWait}, find_goal_lead};

}  // namespace autoref::referee
