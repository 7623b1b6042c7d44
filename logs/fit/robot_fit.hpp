// How fast the robots of a recorded game drove and turned.
#pragma once

#include <cstddef>

#include "logs/fit/block_histogram.hpp"
#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"
#include "soccer/side.hpp"

namespace autoref::logs {

// Collects what the robots of a team reached. An estimate is a high quantile, less the noise's
// deviation, so it is a lower bound of what these robots can do: a team that never drives at full
// speed does not show its top speed, and a manoeuvre shorter than 0.2 s does not show fully. The
// quantiles are those that come closest to the limits of simulated robots.
class RobotFit {
 public:
  // Adds the robots that play on `side`.
  void add(const RecordedMotion& motion, Side side);

  Estimate speed_mps() const;
  Estimate acceleration_mps2() const;  // while gaining speed
  Estimate braking_mps2() const;       // while losing speed, positive
  Estimate angular_speed_radps() const;
  Estimate angular_acceleration_radps2() const;

 private:
  void start_block();
  void add_frame(const RecordedMotion& motion, std::size_t robot, std::size_t frame);

  BlockHistogram speed_mps_{15};
  BlockHistogram acceleration_mps2_{15};
  BlockHistogram braking_mps2_{15};
  BlockHistogram angular_speed_radps_{50};
  BlockHistogram angular_acceleration_radps2_{250};
};

}  // namespace autoref::logs
