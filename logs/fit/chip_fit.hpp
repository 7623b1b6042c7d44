// Estimates how a chipped ball flies and bounces.
#pragma once

#include <vector>

#include "logs/fit/chip_path.hpp"
#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"

namespace autoref::logs {

// Collects the chip kicks of recordings without heights; an episode is one of them.
// Cameras must be calibrated, as a chip is recognised by its parallax.
class ChipFit {
 public:
  void add(const RecordedMotion& motion);

  // Fractions of speed kept at landings. Their intervals allow for an error of 15 % in a single
  // chip, which may be fitted wrongly; the mean of n chips is then wrong by 15 % / n.
  Estimate hop_first_xy() const;
  Estimate hop_first_z() const;
  Estimate hop_later_xy() const;

  // Mean and standard deviation of the elevation of chip kicks, without errors of measurement: at
  // least 3 and 8 chips. The intervals assume a normal distribution.
  Estimate chip_angle_deg() const;
  Estimate chip_angle_noise_deg() const;

 private:
  std::vector<Chip> chips_;
};

}  // namespace autoref::logs
