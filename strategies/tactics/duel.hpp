// Fighting for a ball that an opponent has, too.
#pragma once

#include "soccer/random.hpp"
#include "strategies/tactics/outlook.hpp"

namespace autoref::strategies {

// Whether the opponent that is first at the ball has it in its mouth.
bool opponent_has_ball(const Outlook& outlook);

// Orders for the robot of that index to get between the ball that an opponent has and the own goal,
// front to the ball, and to press against it there.
RobotCommand block_ball(const Outlook& outlook, int index);

// A face-off: the ball is held from both sides. To one side with it, by chance, and after a while
// to the other or the same again.
class FaceOff {
 public:
  explicit FaceOff(const Outlook& outlook)
      : outlook_(outlook), random_(outlook.briefing().random) {}

  RobotCommand break_away(double now_s);

 private:
  const Outlook& outlook_;
  RandomStream random_;
  double until_s_ = 0;
  double side_ = 1;
};

}  // namespace autoref::strategies
