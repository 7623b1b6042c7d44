// A ball in a goal: whose goal it is, and what follows where it does not count.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// The side whose goal the ball is in, if it is in one.
std::optional<Side> conceding_side(const RefereeInput& input);

// Play goes on with a goal kick of `defender`, or with a corner kick at its end: the free kick that
// follows the finding's event is taken from there.
void restart_with_goal_kick(Finding& finding, const RefereeInput& input, Side defender);
void restart_with_corner_kick(Finding& finding, const RefereeInput& input, Side defender);

}  // namespace autoref::referee
