// Detects who wins duels for the ball, as defined in play_counts.hpp.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/side.hpp"

namespace autoref::game {

class Duels {
 public:
  explicit Duels(double frame_rate_hz);

  // Processes a frame of play. `touched`: the sides that touched the ball; `kicked`: the side whose
  // kick is in progress. Returns the winner if a duel has just been won.
  std::optional<Side> update(const sim::WorldState& now, const PerSide<bool>& touched,
                             std::optional<Side> kicked);
  void stop();  // play has stopped

 private:
  // How close a side's nearest robot is to the ball.
  struct Nearness {
    bool is_at_ball = false;  // within kDuel_m
    bool is_in_it = false;    // within kDuelOver_m
  };
  static Nearness nearness(const sim::WorldState& now, Side side);
  void await(bool both_at_ball);

  enum class Stage { kNone, kOn, kDrawn };  // kDrawn lasts until the robots separate

  int begin_frames_;
  int most_frames_;
  Stage stage_ = Stage::kNone;
  int frames_ = 0;  // since both sides reached the ball, or since the duel began
};

}  // namespace autoref::game
