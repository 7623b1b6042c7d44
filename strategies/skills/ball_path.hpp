// Two-phase prediction of the ball's path: after a kick the ball slides, then it rolls. Also
// estimates when robots reach points and the moving ball.
#pragma once

#include <array>

#include "soccer/tracks.hpp"
#include "strategies/strategy.hpp"

namespace autoref::strategies {

// The path of a free ball on the carpet. The decelerations are those that teams measure on their
// carpets (sim/README.md): 3.4 m/s^2 while sliding, down to 0.67 of the kick speed, then 0.30 m/s^2
// while rolling.
class BallPath {
 public:
  static constexpr int kSteps = 20;
  static constexpr double kStep_s = 0.1;
  static constexpr double kLongest_s = kSteps * kStep_s;

  // Updates the path with the ball in the next frame, extrapolated by `latency_s` to when commands
  // take effect. Call it for every frame, because kicks are detected from jumps in speed.
  void follow(const TrackedBall& ball, double latency_s);

  // The ball's position at a step of the table, from 0 (now) to kSteps.
  const Vec2& at_step(int step) const { return table_[static_cast<std::size_t>(step)]; }
  const Vec2& now_m() const { return table_[0]; }
  const Vec2& end_m() const { return table_[kSteps]; }

  double speed_mps() const { return speed_mps_; }
  const Vec2& direction() const { return direction_; }  // unit vector
  Vec2 velocity_mps() const { return direction_ * speed_mps_; }

 private:
  double kick_mps_ = 0;  // speed at the last detected kick
  double last_mps_ = 0;
  double speed_mps_ = 0;
  Vec2 direction_{1, 0};
  std::array<Vec2, kSteps + 1> table_;
};

// Kick speed at which the ball still moves at `arrival_mps` after `distance_m`.
double kick_for_mps(double distance_m, double arrival_mps);

// A ball kicked at a given speed. It answers queries about several distances.
class KickedBall {
 public:
  explicit KickedBall(double kick_mps);

  // Time in seconds that the ball takes to travel `distance_m`; 10 if the ball never gets that far.
  double roll_time_s(double distance_m) const;

 private:
  double kick_mps_;
  double rolls_mps_;  // speed at which sliding ends
  double slide_s_;    // duration and length of the sliding phase
  double slide_m_;
};

// Time in seconds until `robot` can stand at `point_m`, if it accelerates, cruises and brakes along
// the straight path, starting at its current velocity.
double time_to_s(const TrackedRobot& robot, const Vec2& point_m, const Abilities& abilities);

// Where and when a robot can first reach the ball.
struct BallInterception {
  Vec2 point_m{0, 0};
  double time_s = 0;  // time from now until both robot and ball are at the point
};

// The first point of the ball's path that `robot` reaches no later than the ball; the end of the
// path if the robot cannot catch up with the ball. Points outside the field do not count.
BallInterception intercept(const TrackedRobot& robot, const BallPath& path,
                           const Abilities& abilities, const Field& field);

}  // namespace autoref::strategies
