// A decision of the referee and its reasons: one row of a game's event log.
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

// The robot that touched the ball last, as far as vision can tell.
struct LastTouch {
  std::optional<Side> side;      // nullopt if unknown
  std::optional<RobotId> robot;  // nullopt if unknown or ambiguous within the side
  double time_s = 0;             // when the robot touched the ball
  double gap_m = 0;              // gap between the ball's surface and the robot's hull at that time
  double speed_change_mps = 0;   // change in the ball's velocity that friction does not explain
  std::optional<RobotId> runner_up;  // the second most likely toucher
  // Probability, from 0.5 to 1, that no later touch by the other side is hidden in a gap in vision
  // (touch/kept_touch.hpp). It is 1 if there was no gap since or around this touch.
  double kept = 1;
};

// A half's clock: time played and time left, counted as the rule book says.
struct HalfClock {
  double played_s = 0;
  double left_s = 0;
};

// A completed kick of a shoot-out.
struct ShootoutKick {
  Side kicker = Side::kWest;
  int number = 0;  // counted per side, from 1
  bool has_scored = false;
};

struct Decision {
  std::int64_t frame = 0;
  double time_s = 0;
  std::string_view transition;  // label of the machine's transition (referee/README.md)
  State from = State::kInit;
  State to = State::kInit;
  std::optional<Command> command;  // sent with this decision, if any
  Finding finding;                 // the reason for the decision; `card` is the card actually shown
  std::string card_reason;         // why that card was shown; empty without a card
  LastTouch last_touch;

  // The state of the game.
  Stage stage = Stage::kFirstHalfPre;         // before the decision
  std::optional<HalfClock> clock;             // before the decision; nullopt if no half is running
  PerSide<int> goals;                         // after the decision
  PerSide<int> shootout_goals;                // after the decision
  bool blue_on_positive_half = true;          // after the decision
  std::optional<ShootoutKick> shootout_kick;  // the kick that the decision ended

  // The restart after a call that stopped play, or that changed the restart during a stop.
  std::optional<Command> restart() const {
    // If nobody commands the game, play continues after a call.
    const bool stops =
        from != to || (from == State::kRun && entry_of(finding.event).effect == Effect::kStopsPlay);
    const bool decides = stops || finding.event == Event::kAttackerStaysNearArea ||
                         finding.event == Event::kBoundaryCrossing;
    return is_call(finding.event) && decides ? std::optional(finding.restart) : std::nullopt;
  }
};

}  // namespace autoref::referee
