// Touches of the ball in play that rules of the defence areas are to judge.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// What `check` makes of the touches that have just become sure, the oldest first: touches of the
// ball in play by a known robot whose place was seen then.
std::optional<Finding> find_in_touches(const PlayState& play, const RefereeInput& input,
                                       std::optional<Finding> (*check)(const BallTouch& touch,
                                                                       const RefereeInput& input));

}  // namespace autoref::referee
