// Touches of the ball in play that rules of the defence areas are to judge.
#pragma once

#include <optional>

#include "referee/finding.hpp"
#include "referee/machine/memory.hpp"
#include "referee/moment.hpp"

namespace autoref::referee {

// What `judge` makes of the touches that have just become sure, the oldest first: touches of the
// ball in play by a known robot whose place was seen then.
std::optional<Finding> find_in_touches(const PlayMemory& play, const Moment& moment,
                                       std::optional<Finding> (*judge)(const BallTouch& touch,
                                                                       const Moment& moment));

}  // namespace autoref::referee
