// Touches for which non-stopping fouls were called (2026, Non Stopping Fouls).
#pragma once

#include "referee/machine/rule_watch.hpp"
#include "referee/touch/touch_history.hpp"

namespace autoref::referee {

// Whether `touch` is the called one, or continues it.
bool is_called(const CalledTouch& called, const BallTouch& touch);

// Records that `touch` was called at `now_s`.
CalledTouch called_at(const BallTouch& touch, double now_s);

}  // namespace autoref::referee
