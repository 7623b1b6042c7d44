// Decisions of the robot at the ball: shoot, pass, carry, clear, or fight for the ball.
#pragma once

#include <array>
#include <optional>

#include "strategies/tactics/duel.hpp"
#include "strategies/tactics/kick_choice.hpp"
#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// Controls the robot at the ball. Stores the robot's last choice, and the receiver of a pass under
// way.
class BallHandler {
 public:
  explicit BallHandler(const PredictedState& predicted);

  // Updates the state. Call it for every view, before play().
  void update();

  // Commands for the robot with that index to go for the ball and play it.
  RobotCommand play(int index);

  // must_let_go() says whether the robot with that index must leave the ball because it has
  // dribbled the ball nearly too far and no kick helps. let_go() returns the commands to leave it.
  bool must_let_go(int index) const;
  RobotCommand let_go(int index) const;

  // The number of the robot that is to receive the pass under way.
  std::optional<int> receiver() const { return receiver_; }
  const Choice& choice() const { return choice_; }

 private:
  Choice choose(int index, const Vec2& from_m) const;
  std::optional<Hold> hold_of(int index, const Vec2& from_m) const;
  void note_hold(const TrackedRobot& robot, bool holds);
  void note_contacts();
  bool is_committed(const TrackedRobot& robot) const;
  RobotCommand carry(int index) const;
  RobotCommand strike(int index) const;
  RobotCommand take_restart(const TrackedRobot& robot, const Obstacles& obstacles,
                            const DrivingStyle& style) const;
  double hasty_share() const;
  bool has_dribbled(double share) const;
  double dribbled_m(const Vec2& from_m) const;
  double dribble_left_s(const TrackedRobot& robot, bool holds) const;
  bool must_release() const;
  bool is_hasty() const;
  bool is_hurried(int index) const;
  bool may_score() const;
  bool may_dribble_restart() const;

  const PredictedState& predicted_;
  FaceOff face_off_;
  Choice choice_;
  int restart_taker_ = -1;   // number of the robot that takes the restart; -1: none
  int holder_ = -1;          // number of the robot that has the ball; -1: none
  Vec2 taken_from_m_{0, 0};  // where that robot gained the ball
  // Where the ball was when each robot came into contact with it, by number.
  std::array<std::optional<Vec2>, kMaxRobots> contact_from_m_;
  std::optional<int> receiver_;
  double receiver_until_s_ = 0;
  std::array<double, kMaxRobots> chances_{};  // probability that each team-mate scores with a shot
                                              // from its position, by number
};

}  // namespace autoref::strategies
