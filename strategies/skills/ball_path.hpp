// Where the ball will be, phase by phase: after a kick it slides, then it rolls.
#pragma once

#include <array>

#include "soccer/tracks.hpp"

namespace autoref::strategies {

// The way of a ball on the carpet that nothing meets. The decelerations are those that teams
// measure on their carpet (sim/README.md): 3.4 m/s^2 sliding until 0.67 of the kick's speed is
// left, then 0.30 m/s^2 rolling.
class BallPath {
 public:
  static constexpr int kSteps = 20;
  static constexpr double kStep_s = 0.1;
  static constexpr double kLongest_s = kSteps * kStep_s;

  // Takes the next frame of the ball, moved on by the `latency_s` until commands take effect. Kicks
  // are told from the speed's peaks, so that it must be called for every frame.
  void follow(const TrackedBall& ball, double latency_s);

  // Where the ball is at a step of the table, from 0 (now) to kSteps.
  const Vec2& at_step(int step) const { return table_[static_cast<std::size_t>(step)]; }
  const Vec2& now_m() const { return table_[0]; }
  const Vec2& end_m() const { return table_[kSteps]; }

  double speed_mps() const { return speed_mps_; }
  const Vec2& direction() const { return direction_; }  // unit vector
  Vec2 velocity_mps() const { return direction_ * speed_mps_; }

 private:
  double kick_mps_ = 0;  // the speed's last peak
  double last_mps_ = 0;
  double speed_mps_ = 0;
  Vec2 direction_{1, 0};
  std::array<Vec2, kSteps + 1> table_;
};

// The speed that a kick needs to arrive after `distance_m` with `arrival_mps`.
double kick_for_mps(double distance_m, double arrival_mps);

// Seconds that a ball kicked with `kick_mps` needs for `distance_m`; 10 where it does not get
// there.
double roll_time_s(double kick_mps, double distance_m);

}  // namespace autoref::strategies
