// Touches of the ball in play that the rules on defence areas check, and touches for which
// non-stopping fouls were called (2026, Non Stopping Fouls).
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/machine/rule_watch.hpp"
#include "referee/referee_input.hpp"
#include "referee/touch/touch_history.hpp"

namespace autoref::referee {

// A rule's verdict on a touch by a known robot whose position at the time of the touch was known.
// `check` is called for newly confirmed touches, oldest first.
using TouchCheck = std::optional<Finding> (*)(RefereeState& state, const BallTouch& touch,
                                              const RefereeInput& input);
std::optional<Finding> find_in_touches(RefereeState& state, const RefereeInput& input,
                                       TouchCheck check);

// Whether `touch` is the touch that was called, or its continuation.
bool is_called(const CalledTouch& called, const BallTouch& touch);

// The record that a foul was called for `touch` at `now_s`.
CalledTouch called_at(const BallTouch& touch, double now_s);

}  // namespace autoref::referee
