// "When the ball leaves the field without entering a goal, a free kick is awarded to the team which
// touched the ball less recently" (paper, section 4.2): throw-in, corner kick or goal kick.
//
// Deviation D14: where the last touch is unknown, it is a goal kick behind a goal line, which is
// the paper's "otherwise", and over a touch line a force start from the place of the throw-in.
// Other books do not say "otherwise": there it is a force start from a neutral place behind a goal
// line, too, so that a touch that nobody saw is no one's gain.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_ball_leaves_field(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kBallLeavesFieldRule{
    RuleId::kBallLeavesField, {State::kRun}, find_ball_leaves_field};

}  // namespace autoref::referee
