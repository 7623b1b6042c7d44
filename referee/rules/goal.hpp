// "When the ball enters one of the goals, a goal is awarded to the appropriate team, the ball is
// placed in the center of the field, and a kickoff is signaled" (paper, section 4.2): of the team
// that conceded. A ball in a goal counts for that goal's opponents, whoever touched it last.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_goal(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kGoalRule{RuleId::kGoal, {State::kRun}, find_goal};

}  // namespace autoref::referee
