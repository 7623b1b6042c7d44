// The kicker of a restart must not touch the ball again, once it is in play, before another robot
// has (Laws 2014, laws 8 and 13 to 17; 2026, Double Touch). "Again" means that the ball has been
// apart from the robot: bumps while the kick is being taken are one touch. A touch by somebody
// unknown may be another robot's, and then nobody is blamed.
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_double_touch(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kDoubleTouchRule{RuleId::kDoubleTouch, {State::kRun}, find_double_touch};

}  // namespace autoref::referee
