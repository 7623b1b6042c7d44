// Fighting for a ball that an opponent also has.
#pragma once

#include "soccer/random.hpp"
#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// Whether the opponent that reaches the ball first already has it in its dribbler zone.
bool opponent_has_ball(const PredictedState& predicted);

// Commands for the robot with that index to get between an opponent's ball and the team's own goal,
// facing the ball, and to press against the ball.
RobotCommand block_ball(const PredictedState& predicted, int index);

// Commands for a face-off, in which robots of both teams hold the ball: pull it to a random side,
// and choose a side again after a while.
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
