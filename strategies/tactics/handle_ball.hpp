// What the robot at the ball does with it: shoot, pass, carry it on, clear it, or fight for it.
#pragma once

#include <array>
#include <optional>

#include "strategies/tactics/duel.hpp"
#include "strategies/tactics/kick_choice.hpp"
#include "strategies/tactics/predicted_state.hpp"

namespace autoref::strategies {

// The robot at the ball. Remembers what it is about to do, and for whom a pass on its way is.
class BallHandler {
 public:
  explicit BallHandler(const PredictedState& predicted);

  // Keeps the memory up to date; for every view, before play().
  void update();

  // Commands for the robot of that index to go for the ball and make the best of it.
  RobotCommand play(int index);

  // For whom the pass under way is, by number.
  std::optional<int> receiver() const { return receiver_; }
  const Choice& choice() const { return choice_; }

 private:
  Choice choose(int index, const Vec2& from_m) const;
  void note_hold(const TrackedRobot& robot, bool holds);
  RobotCommand carry(int index) const;
  RobotCommand strike(int index) const;
  bool must_release() const;

  const PredictedState& predicted_;
  FaceOff face_off_;
  Choice choice_;
  int holder_ = -1;          // number of the robot that has the ball; -1: nobody
  Vec2 taken_from_m_{0, 0};  // where it got it
  std::optional<int> receiver_;
  double receiver_until_s_ = 0;
  std::array<double, kMaxRobots> chances_{};  // of a mate's shot from where it is, by number
};

}  // namespace autoref::strategies
