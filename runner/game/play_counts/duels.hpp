// Who wins the ball where robots of both teams want it. The definition is in play_counts.hpp.
#pragma once

#include <optional>

#include "sim/world.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

class Duels {
 public:
  explicit Duels(double frame_rate_hz);

  // One frame of play; `touched`: by which sides the ball was; `kicked`: whose kick away is under
  // way. Returns who has just won a duel.
  std::optional<Side> update(const sim::WorldState& now, const PerSide<bool>& touched,
                             std::optional<Side> kicked);
  void stop();  // play has stopped

 private:
  // Of the side's robot nearest to the ball.
  struct Nearness {
    bool is_at_ball = false;  // within kDuel_m
    bool is_in_it = false;    // within kDuelOver_m
  };
  static Nearness nearness(const sim::WorldState& now, Side side);
  void await(bool both_at_ball);

  enum class Stage { kNone, kOn, kDrawn };  // drawn: until they part

  int begin_frames_;
  int most_frames_;
  Stage stage_ = Stage::kNone;
  int frames_ = 0;  // both at the ball, or of the duel
};

}  // namespace autoref::runner
