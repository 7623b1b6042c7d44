// What the referee decided, and why: one row of a game's event log.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
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

// The clock of a half: what was played of it and what is left, as the rule book counts.
struct HalfClock {
  double played_s = 0;
  double left_s = 0;
};

// A kick of a shoot-out that is over.
struct ShootoutKick {
  Side kicker = Side::kWest;
  int number = 0;  // of the kicker's side, from 1
  bool has_scored = false;
};

struct Decision {
  std::int64_t frame = 0;
  double time_s = 0;
  std::string_view transition;  // label of the machine's transition, see referee/README.md
  State from = State::kInit;
  State to = State::kInit;
  std::optional<Command> command;  // sent with this decision; none where nothing was sent
  Finding finding;                 // what was decided on; its card is the one that was shown
  std::string card_reason;         // why that card, and not another or none; empty without one
  LastTouch last_touch;

  // How the game stood.
  Stage stage = Stage::kFirstHalfPre;         // when it was decided
  std::optional<HalfClock> clock;             // likewise; none where no half is running
  PerSide<int> goals;                         // after it
  PerSide<int> shootout_goals;                // likewise
  std::optional<ShootoutKick> shootout_kick;  // that it ended

  // What play goes on with after a call that stopped it, or that changed the restart after a stop.
  std::optional<Command> restart() const {
    const bool decides =
        is_call(finding.event) && (from != to || finding.event == Event::kAttackerStaysNearArea);
    return decides ? std::optional(finding.restart) : std::nullopt;
  }
};

}  // namespace autoref::referee
