// A goal counts only if the ball was at most 0.15 m high since the scorers' last touch, and they
// have not fouled in the 2 s before; at penalties always (2026, Scoring Goals). Otherwise play goes
// on as if the ball had crossed the goal line beside the goal.
//
// Heights that vision cannot tell count as on the ground, and where somebody unknown touched the
// ball since, the goal stands. The height is that of the ball's top, as in the Laws.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_goal_valid(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kGoalValidRule{RuleId::kGoalValid, {State::kRun}, find_goal_valid};

}  // namespace autoref::referee
