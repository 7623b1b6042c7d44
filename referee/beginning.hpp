// How a game begins, if not with the first kick-off: in the middle of the first half.
#pragma once

#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::referee {

// The half begins with the first frame, at 0:0. Who touched the ball before is unknown.
struct Beginning {
  // The pending restart: PREPARE_KICKOFF, PREPARE_PENALTY, DIRECT_FREE or INDIRECT_FREE of a side,
  // or FORCE_START. nullopt: play is on.
  std::optional<Command> restart = {};
  // Where the ball is placed for the restart; unused if play is on.
  Vec2 ball_m{0, 0};
  // STOP comes first, and the restart follows as usual. Otherwise it is signalled at once; a
  // kick-off and a penalty kick then still need the robots to be ready.
  bool is_stopped = false;
};

}  // namespace autoref::referee
