// The taker of a restart, which must not touch the ball again before another robot has touched it.
#pragma once

#include "soccer/team_view.hpp"

namespace autoref::strategies {

// Remembers the number of the robot that took the team's restart until another robot has the ball.
class RestartTaker {
 public:
  // `taker` is the number of the robot that goes for the ball, -1 for none. Call it for every view.
  void update(const TeamView& now, int taker);

  int number() const { return number_; }  // -1: none

 private:
  int number_ = -1;
};

}  // namespace autoref::strategies
