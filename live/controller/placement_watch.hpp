// Detects when a team has placed the ball; the game controller relies on automatic referees for
// this.
#pragma once

#include <optional>

#include "soccer/referee_signal.hpp"
#include "soccer/rules/game_event.hpp"
#include "soccer/tracks.hpp"

namespace autoref::live {

class PlacementWatch {
 public:
  // Call once per frame with the controller's signal. Returns PLACEMENT_SUCCEEDED once per
  // BALL_PLACEMENT, when the ball has been at rest within 0.15 m of its target for half a second
  // (2026, Ball Placement) and the placing team's robots have left it.
  std::optional<GameEvent> update(const RefereeSignal& signal, const Tracks& tracks);

 private:
  void begin(const RefereeSignal& signal, const Tracks& tracks);
  bool is_placed(const RefereeSignal& signal, const Tracks& tracks);

  std::optional<std::uint32_t> command_counter_;  // counter of the current BALL_PLACEMENT
  bool is_reported_ = false;
  double begun_s_ = 0;
  std::optional<Vec2> begun_m_;  // the ball's position at the start of the BALL_PLACEMENT
  std::optional<double> at_rest_since_s_;
};

}  // namespace autoref::live
