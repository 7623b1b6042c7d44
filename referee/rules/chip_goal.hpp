// A ball whose top has been above 150 mm since the attackers' last touch scores no goal, unless it
// was rolling again (Laws 2014, law 12): an indirect free kick from where that attacker touched it.
//
// Heights that vision cannot tell count as on the ground: most balls are. Where somebody unknown
// touched the ball since, it may have been a team-mate, and the goal stands. A ball that a
// defender lifts into its own goal after it has rolled is a goal, too.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_chip_goal(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kChipGoalRule{RuleId::kChipGoal, {State::kRun}, find_chip_goal};

}  // namespace autoref::referee
