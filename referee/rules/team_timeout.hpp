// Timeouts (Laws 7; 2026): on a team's request while play is stopped, so many and so long
// altogether, and other ones in extra time. Not before the first kick-off, when the match has not
// begun, and not in a shoot-out.
//
// A timeout lasts for as long as its team asks, or until its time is used up. Where both ask at
// once, the side that takes the restart comes first; where neither does, the one that has used less
// time, then fewer timeouts, then the one that did not kick off this half.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_timeout(RefereeState& state, const RefereeInput& input);
std::optional<Finding> find_timeout_over(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kTimeoutRule{RuleId::kTimeouts, {State::kWaitStop}, find_timeout};
inline constexpr Rule kTimeoutOverRule{RuleId::kTimeouts, {State::kTimeout}, find_timeout_over};

}  // namespace autoref::referee
