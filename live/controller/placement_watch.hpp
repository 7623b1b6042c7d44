// Finds out when a team has placed the ball, which the game controller learns from automatic
// referees.
#pragma once

#include <optional>

#include "soccer/referee_signal.hpp"
#include "soccer/rules/game_event.hpp"
#include "soccer/tracks.hpp"

namespace autoref::live {

class PlacementWatch {
 public:
  // Once per frame, with the controller's signal. Returns PLACEMENT_SUCCEEDED once per
  // BALL_PLACEMENT, when the ball has been at rest within 0.15 m of its position for half a second
  // (2026, Ball Placement) and the placing team's robots have left it.
  std::optional<GameEvent> update(const RefereeSignal& signal, const Tracks& tracks);

 private:
  void begin(const RefereeSignal& signal, const Tracks& tracks);
  bool is_placed(const RefereeSignal& signal, const Tracks& tracks);

  std::optional<std::uint32_t> command_counter_;  // of the BALL_PLACEMENT under way
  bool is_reported_ = false;
  double begun_s_ = 0;
  std::optional<Vec2> begun_m_;  // the ball's position then
  std::optional<double> at_rest_since_s_;
};

}  // namespace autoref::live
