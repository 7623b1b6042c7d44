// The straight path of a kicked ball that nobody touches, in closed form from sim::BallParameters.
// A rolling ball whose deceleration grows with its speed gets the mean deceleration over its path.
#pragma once

#include <array>

#include "sim/configuration.hpp"
#include "soccer/geometry.hpp"

namespace autoref::game {

// After a flat kick the ball slides, then rolls. After a chip kick it flies, then rolls; later hops
// are neglected, which makes the path a few hundredths too long.
class BallTrajectory {
 public:
  // From `from_m` at `velocity_mps` in the plane and `vertical_mps` upwards.
  BallTrajectory(const Vec2& from_m, const Vec2& velocity_mps, double vertical_mps,
                 const sim::BallParameters& ball);

  Vec2 point_m(double path_m) const { return from_m_ + path_m * direction_; }
  const Vec2& from_m() const { return from_m_; }
  const Vec2& direction() const { return direction_; }  // unit vector
  double flight_m() const { return flight_m_; }         // first flight; 0 for a flat kick
  double reach_m() const { return phases_[0].length_m + phases_[1].length_m; }  // until at rest

  // At distance `path_m` along the path, from 0 to reach_m().
  double speed_mps(double path_m) const;
  double time_s(double path_m) const;
  double height_m(double path_m) const;  // bottom of the ball, during its first flight

 private:
  // A phase with constant deceleration.
  struct Phase {
    double speed_mps = 0;  // initial
    double slowing_mps2 = 0;
    double length_m = 0;

    double speed_at_mps(double path_m) const;
    double time_at_s(double path_m) const;
  };

  Vec2 from_m_;
  Vec2 direction_;
  double vertical_mps_;
  double flight_m_ = 0;
  std::array<Phase, 2> phases_;
};

}  // namespace autoref::game
