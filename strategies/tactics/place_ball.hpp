// Ball placement by the team's own robots (2026, Ball Placement).
#pragma once

#include <optional>

#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// Controls the robot that places the ball: it grips the ball with its dribbler, pulls it backwards
// to the designated position, sets it down and backs away.
class BallPlacer {
 public:
  explicit BallPlacer(const PredictedState& predicted) : predicted_(predicted) {}

  // Chooses the robot that places the ball. Call update() for every view, with the view's ball.
  void update(const TrackedBall& tracked);

  // The index of the robot that places the ball; -1 unless this team is to place it.
  int index() const { return index_; }

  // Commands for the robot that places the ball.
  RobotCommand play();

 private:
  int choose() const;
  Vec2 next_goal_m() const;
  bool still_holds(const TrackedRobot& robot) const;
  RobotCommand approach(const TrackedRobot& robot, const Vec2& pull);
  RobotCommand grip(const TrackedRobot& robot, const Vec2& pull);
  RobotCommand press(const TrackedRobot& robot);
  RobotCommand pull_ball(const TrackedRobot& robot, const Vec2& goal_m);
  RobotCommand set_down(const TrackedRobot& robot);

  const PredictedState& predicted_;
  int index_ = -1;
  int number_ = -1;         // the robot's number; -1 for no robot
  int former_ = -1;         // number of the robot that has already tried
  double since_s_ = 0;      // when the robot was chosen
  Vec2 ball_m_{0, 0};       // the ball's position when commands take effect
  Vec2 tracked_m_{0, 0};    // the ball's position in the view
  bool is_hidden_ = false;  // whether the tracker has stopped the ball where it was last seen
  bool holds_ = false;
  double held_since_s_ = 0;
  std::optional<double> set_down_s_;  // when the robot began to set the ball down
  Vec2 velocity_mps_{0, 0};           // velocity commanded while the robot holds the ball
  double turn_radps_ = 0;
  double now_s_ = 0;
  double step_s_ = 0;  // time since the previous view
};

// Whether the referee is placing the ball for the opponents' restart, so robots must keep clear of
// it.
bool must_clear_placement(const PredictedState& predicted);

// A better position for a robot that would come too near to the ball, or to its path to the
// designated position, on its way to `waypoint`. The better position is near the robot's current
// position. Returns nullopt if the robot's way is clear.
std::optional<Waypoint> clear_of_placement(const PredictedState& predicted,
                                           const TrackedRobot& robot, const Vec2& waypoint_m);

// Commands that drive the robot with that index around other robots to `waypoint`.
RobotCommand step_aside(const PredictedState& predicted, int index, const Waypoint& waypoint);

}  // namespace autoref::strategies
