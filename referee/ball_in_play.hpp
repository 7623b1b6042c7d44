// From a restart's signal until the ball is in play ("once it has moved 50 mm", Laws 2014, laws 8,
// 9 and 13), and what the ball has done since.
#pragma once

#include "referee/memory.hpp"
#include "referee/moment.hpp"

namespace autoref::referee {

// Play has just been started with `command`, by `kicker` unless it is a force start.
PlayMemory play_begun(Command command, std::optional<Side> kicker, const Moment& moment);

// Follows the ball through one frame of RUN.
void watch_play(PlayMemory& play, const Moment& moment);

}  // namespace autoref::referee
