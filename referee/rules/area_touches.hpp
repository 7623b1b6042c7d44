// Touches of the ball in play that rules of the defence areas are to judge.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// What `check` makes of the touches that have just become sure, the oldest first: touches of the
// ball in play by a known robot whose place was seen then.
using TouchCheck = std::optional<Finding> (*)(RefereeState& state, const BallTouch& touch,
                                              const RefereeInput& input);
std::optional<Finding> find_in_touches(RefereeState& state, const RefereeInput& input,
                                       TouchCheck check);

}  // namespace autoref::referee
