// A ball in a goal: whose goal it is, and what follows where it does not count.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/moment.hpp"

namespace autoref::referee {

// The side whose goal the ball is in, if it is in one.
std::optional<Side> conceding_side(const Moment& moment);

// Play goes on with a goal kick of `defender`, or with a corner kick at its end.
void restart_with_goal_kick(Finding& finding, const Moment& moment, Side defender);
void restart_with_corner_kick(Finding& finding, const Moment& moment, Side defender);

}  // namespace autoref::referee
