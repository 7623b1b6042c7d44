// Touches of the ball in play, as judged by the rules on defence areas.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"

namespace autoref::referee {

// A rule's verdict on a touch by a known robot whose position was known at that time. `check` is
// called for newly confirmed touches, oldest first.
using TouchCheck = std::optional<Finding> (*)(RefereeState& state, const BallTouch& touch,
                                              const RefereeInput& input);
std::optional<Finding> find_in_touches(RefereeState& state, const RefereeInput& input,
                                       TouchCheck check);

}  // namespace autoref::referee
