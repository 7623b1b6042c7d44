// The kicks of a shoot-out (Laws 2014, appendix A; 2026), instead of all other rules.
//
// A kick is over with a goal, when its time is up, when the ball is out, or when a defender has
// saved it: touched it last, and it moves away from the goal. It scores only in the goal that is
// shot at. Fouls during a kick are not judged.
#pragma once

#include <span>

#include "referee/rules/rule.hpp"

namespace autoref::referee {

// kGoal or kPenaltyFailed in RUN.
std::optional<Finding> find_shootout_kick_over(RefereeState& state, const RefereeInput& input);

// kShootoutOver between two kicks, once nothing can change who wins.
std::optional<Finding> find_shootout_over(RefereeState& state, const RefereeInput& input);

// What is asked in a shoot-out, whatever rules are in force.
std::span<const Rule> shootout_rules();

}  // namespace autoref::referee
