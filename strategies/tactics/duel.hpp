// Fighting for a ball that an opponent has, too.
#pragma once

#include "soccer/random.hpp"
#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// Whether the opponent that is first at the ball has it in its mouth.
bool opponent_has_ball(const PredictedState& predicted);

// Commands for the robot of that index to get between the ball that an opponent has and the own
// goal, front to the ball, and to press against it there.
RobotCommand block_ball(const PredictedState& predicted, int index);

// A face-off: the ball is held from both sides. To one side with it, by chance, and after a while
// to the other or the same again.
class FaceOff {
 public:
  explicit FaceOff(const PredictedState& predicted)
      : predicted_(predicted), random_(predicted.context().random) {}

  RobotCommand break_away(double now_s);

 private:
  const PredictedState& predicted_;
  RandomStream random_;
  double until_s_ = 0;
  double side_ = 1;
};

}  // namespace autoref::strategies
