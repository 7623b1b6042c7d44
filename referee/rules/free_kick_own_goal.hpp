// A ball straight from a side's own restart into its own goal is no goal, but a corner kick for the
// opponents (Laws 2014, law 13; 2026, Free Kick). A touch by somebody unknown may be a second
// robot's. Penalty kicks are taken at the other end.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_free_kick_own_goal(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kFreeKickOwnGoalRule{
    RuleId::kFreeKickOwnGoal, {State::kRun}, find_free_kick_own_goal};

}  // namespace autoref::referee
