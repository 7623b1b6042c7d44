// Estimates how far kicks stray from the kicking robot's heading.
#pragma once

#include <span>
#include <vector>

#include "logs/fit/estimate.hpp"
#include "logs/fit/kicks.hpp"
#include "logs/fit/recorded_motion.hpp"

namespace autoref::logs {

// The direction of a straight kick of a ball that lay at the robot's plate.
struct KickAngle {
  // From the heading to the left, without the ball's own motion along the plate.
  double off_rad = 0;
  double error_rad2 = 0;  // variance due to errors of measurement, except those of headings
  double headings = 0;    // the variance due to these / that of a detected heading
};

// Collects the directions of straight kicks relative to the kicking robots' headings.
class KickFit {
 public:
  // `kicks`: those found in `motion` (kicks_in()).
  void add(const RecordedMotion& motion, std::span<const Kick> kicks);

  // The standard deviation of the kicks' direction, without errors of measurement, but including
  // what cameras with systematic errors of their own add to headings. An episode is a kick.
  // `robot_noise_rad`: the standard deviation of a detected heading.
  Estimate direction_noise_deg(double robot_noise_rad) const;

 private:
  std::vector<KickAngle> angles_;
};

}  // namespace autoref::logs
