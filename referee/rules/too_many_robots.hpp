// More robots on the field than a side may have, too long after a card took one off (Laws 3 and 12;
// 2026).
//
// A robot leaves by its own wheels: it is off the field once all of it is beyond the lines. Each
// card is called once. Where both sides are at fault, the finding names none, and play goes on with
// a force start.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_too_many_robots(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kTooManyRobotsRule{
    RuleId::kTooManyRobots, {State::kRun, State::kWaitStop}, find_too_many_robots};

}  // namespace autoref::referee
