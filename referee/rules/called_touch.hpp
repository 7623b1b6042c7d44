// Touches that fouls were called for which do not stop play (2026, Non Stopping Fouls).
#pragma once

#include "referee/machine/rule_watch.hpp"
#include "referee/touch/touch_history.hpp"

namespace autoref::referee {

// Whether `touch` is the one that was called, or goes on from it.
bool is_called(const CalledTouch& called, const BallTouch& touch);

// Notes that `touch` is called for at `now_s`.
CalledTouch called_at(const BallTouch& touch, double now_s);

}  // namespace autoref::referee
