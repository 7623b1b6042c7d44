// When the cameras capture, and by how much they disagree.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"

namespace autoref::logs {

// The captures of one camera.
struct CameraTiming {
  std::int64_t captures = 0;
  double rate_hz = 0;  // from the median interval
  // How long after the camera with the lowest number it captures: circular mean and standard
  // deviation, the mean from minus to plus half an interval. Clocks that differ by more than 10 ms
  // are corrected before (league/camera_clocks.hpp); smaller differences are part of the phase.
  Measured phase_s;
};

class RigFit {
 public:
  void add(const RecordedMotion& motion);

  std::map<std::uint32_t, CameraTiming> cameras() const;

  // Whether the phases of two cameras differ, or the phase of one drifts, by more than 5 % of an
  // interval.
  bool cameras_run_freely() const;

  // As sim.vision.camera_error_m: half of the root mean square of the distance between where two
  // cameras see a robot, while it rests or when the second camera takes over. Includes about half
  // of the robots' noise. Cameras can only be compared at seams, where their errors may differ from
  // those elsewhere; the interval allows for as much of that as in simulated cameras.
  Estimate camera_error_m() const;

 private:
  struct Captures {
    std::int64_t captures = 0;
    std::vector<double> intervals_s;  // medians of the parts
    // Sums over the captures of cosine and sine of the phase as an angle.
    double cosines = 0;
    double sines = 0;
    std::int64_t compared = 0;
  };

  void add_captures(const RecordedMotion& motion);
  void add_rests(const RecordedMotion& motion);
  void add_handovers(const RecordedMotion& motion, const RobotMotion& robot);
  void note_disagreement(const Vec2& difference_m);

  std::map<std::uint32_t, Captures> captures_;
  std::vector<double> disagreements_m2_;  // squares, one per rest or handover of a robot
};

}  // namespace autoref::logs
