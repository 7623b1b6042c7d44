// No goal straight from an indirect free kick or a throw-in, which only the kicker has touched: a
// goal kick (Laws 2014, laws 13 and 15). A touch by somebody unknown may be a second robot's.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_indirect_goal(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kIndirectGoalRule{RuleId::kIndirectGoal, {State::kRun}, find_indirect_goal};

}  // namespace autoref::referee
