// Deviation D11: a ball in play that has moved less than 250 mm in 10 s is stuck: a force start
// from a neutral place (2016; Laws 2014, law 9).
#pragma once

#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> find_stuck_ball(RefereeState& state, const RefereeInput& input);

inline constexpr Rule kStuckBallRule{RuleId::kStuckBall, {State::kRun}, find_stuck_ball};

}  // namespace autoref::referee
