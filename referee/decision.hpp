// What the referee decided, and why: one row of a game's event log.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "referee/finding.hpp"
#include "referee/state.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// Who touched the ball last, as far as vision tells.
struct LastTouch {
  std::optional<Side> side;          // none: unknown
  std::optional<RobotId> robot;      // none: unknown, or one of several of that side
  double time_s = 0;                 // of the touch
  double gap_m = 0;                  // from the ball's surface to that robot's hull at that time
  double speed_change_mps = 0;       // of the ball, beyond what the carpet explains
  std::optional<RobotId> runner_up;  // the next best candidate
};

struct Decision {
  std::int64_t frame = 0;
  double time_s = 0;
  std::string_view transition;  // label of the machine's transition, see referee/README.md
  State from = State::kInit;
  State to = State::kInit;
  std::optional<Command> command;  // sent with this decision; none where nothing was sent
  Finding finding;                 // what was decided on
  LastTouch last_touch;

  // What play goes on with after a call that stopped it, or that changed the restart after a stop.
  std::optional<Command> restart() const {
    const bool decides =
        is_call(finding.event) && (from != to || finding.event == Event::kAttackerStaysNearArea);
    return decides ? std::optional(finding.restart) : std::nullopt;
  }
};

}  // namespace autoref::referee
