// The straight kicks in a recorded game.
#pragma once

#include <cstddef>
#include <vector>

#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::logs {

// Distance from a robot's centre to that of a ball at its plate.
inline constexpr double kPlateTouch_m = kFrontDistance_m + kBallRadius_m;

inline constexpr double kKickTimeError_s = 4e-3;  // of the time of a kick that was found

// A straight kick, found by following a sliding ball back to the front of the robot nearest to
// where the stretch begins.
struct Kick {
  std::size_t robot = 0;           // its index in RecordedMotion::robots
  double time_s = 0;               // when the ball left the plate
  double speed_mps = 0;            // of the ball then
  Vec2 direction{1, 0};            // of the ball, a unit vector
  double direction_error_rad = 0;  // standard deviation of that direction
  double across_m = 0;             // of the ball then: to the left of the middle of the plate
  double angle_rad = 0;            // from the robot's heading to the ball's direction
  // Speed at which the ball begins to roll, as a fraction of its speed at the kick. Its deviation
  // is infinite if the ball slides throughout the stretch.
  Measured switch_ratio;

  // Whether it looks like a kick, and not like a deflection or a ball that a robot drives away
  // from.
  bool is_clear() const;
};

// The kicks in the motion. Of `ball`, slide_mps2, roll_mps2 and roll_per_s are used.
std::vector<Kick> kicks_in(const RecordedMotion& motion, const sim::BallParameters& ball);

// The switch ratio most of `kicks` agree on. A deflected ball has spin, so it begins to roll at
// another ratio.
Estimate switch_ratio_of(const std::vector<Kick>& kicks);

}  // namespace autoref::logs
