// Getting at the ball: behind it first, then through it, and a kick once it goes where it should.
#pragma once

#include "soccer/field.hpp"
#include "soccer/team_view.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {

// Where the ball is to go, and how.
struct Intent {
  Vec2 target_m{0, 0};
  double kick_mps = 6.5;
  double tolerance_rad = 0.12;  // kick once the heading is this near to the target
  double hasty_mps = 0;         // a softer kick, in a duel, within the wider tolerance; 0: none
  double hasty_tolerance_rad = 0.7;
};

// Commands for `robot` to meet the ball and send it to the intent's target. `interception_m` is
// where it can meet the ball. `obstacles` are robots only; the ball is kept clear of here.
RobotCommand play_ball(const TrackedRobot& robot, const TrackedBall& ball,
                       const Vec2& interception_m, const Intent& intent, const Obstacles& obstacles,
                       const DrivingStyle& style);

// Whether the ball comes at `robot` so fast that it should be stopped before it is played.
bool comes_at(const TrackedRobot& robot, const TrackedBall& ball);

// Commands for `robot` to stand on the ball's way, at `interception_m`, and take it with the
// dribbler.
RobotCommand receive_ball(const TrackedRobot& robot, const TrackedBall& ball,
                          const Vec2& interception_m, const Obstacles& obstacles,
                          const DrivingStyle& style);

}  // namespace autoref::strategies
