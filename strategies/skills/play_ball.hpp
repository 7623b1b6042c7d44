// Playing the ball: getting behind it, running through it, kicking when the aim is right, and not
// touching it twice at a restart.
#pragma once

#include "soccer/field.hpp"
#include "soccer/team_view.hpp"
#include "strategies/skills/motion.hpp"

namespace autoref::strategies {

// The taker of a restart, which must not touch the ball again before another robot has touched it.
// This class stores the number of the robot that took the team's restart until another robot has
// the ball.
class RestartTaker {
 public:
  // Call update() for every view. `taker` is the number of the robot that goes for the ball; -1 for
  // no robot.
  void update(const TeamView& now, int taker);

  int number() const { return number_; }  // -1 for no robot

 private:
  int number_ = -1;
};

// The target of a kick and how to kick.
struct Intent {
  Vec2 target_m{0, 0};
  double kick_mps = 6.5;
  double tolerance_rad = 0.12;  // largest heading error for a kick
  double hasty_mps = 0;         // speed of a softer kick with a wider tolerance, in a duel; 0 for
                                // no such kick
  double hasty_tolerance_rad = 0.7;
};

// Commands for `robot` to reach the ball and kick it at the intent's target. `interception_m` is
// where the robot can meet the ball. `obstacles` must contain only robots; the ball is avoided
// here.
RobotCommand play_ball(const TrackedRobot& robot, const TrackedBall& ball,
                       const Vec2& interception_m, const Intent& intent, const Obstacles& obstacles,
                       const DrivingStyle& style);

// Whether the ball approaches `robot` so fast that the robot should stop it before it kicks.
bool comes_at(const TrackedRobot& robot, const TrackedBall& ball);

// Commands for `robot` to stand in the ball's path at `interception_m` and stop it with the
// dribbler.
RobotCommand receive_ball(const TrackedRobot& robot, const TrackedBall& ball,
                          const Vec2& interception_m, const Obstacles& obstacles,
                          const DrivingStyle& style);

}  // namespace autoref::strategies
