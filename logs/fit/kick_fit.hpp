// Estimates how far kicks stray from the kicking robot's heading.
#pragma once

#include <span>
#include <vector>

#include "logs/fit/ball_fit.hpp"
#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"

namespace autoref::logs {

// The direction of a straight kick of a ball that lay at the robot's plate.
struct KickAngle {
  double off_rad = 0;         // from the heading, without the plate's own motion
  double heading_factor = 0;  // error of the heading / that of a single detected heading
};

// Collects the directions of straight kicks relative to the kicking robots' headings.
class KickFit {
 public:
  // `kicks`: those found in `motion` (kicks_in()).
  void add(const RecordedMotion& motion, std::span<const Kick> kicks);

  // The standard deviation of the kicks' direction, without errors of measurement. An episode is a
  // kick. `robot_noise_rad`: the standard deviation of a detected heading.
  Estimate direction_noise_deg(double robot_noise_rad) const;

 private:
  std::vector<KickAngle> angles_;
};

}  // namespace autoref::logs
