// Detects changes of the ball's velocity that noise hides between two frames, but not over several.
//
// A two-window change detector (Gustafsson 2000; docs/touch-detection.md): least-squares lines are
// fitted to the five detections that end with each detection and to the five that begin with it. If
// their velocities differ by more than friction and noise explain, and the difference is at its
// peak, the ball hit something there. The delay is five detections.
#pragma once

#include <optional>

#include "referee/touch/frame_history.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "referee/touch_parameters.hpp"

namespace autoref::referee {

struct VelocityChange {
  // The detections on either side of the change; valid until the next frame.
  const StoredFrame* before = nullptr;
  const StoredFrame* after = nullptr;
  double since_s = 0;  // time of the oldest detection used
  BallSegment segment;
  Impulse impulse;
};

class VelocityChangeDetector {
 public:
  // Keeps a reference to the history.
  VelocityChangeDetector(const FrameHistory& frames, const TouchParameters& parameters)
      : frames_(frames), parameters_(parameters) {}

  // Forgets all detections.
  void restart() { known_ = 0; }

  // Processes the newest detection of the history; returns the velocity change that it completes.
  std::optional<VelocityChange> update();

 private:
  static constexpr int kHalf = 4;  // intervals on either side
  static constexpr int kUsed = 2 * kHalf + 2;

  // A constant velocity fitted to detections.
  struct Line {
    double middle_s = 0;
    Vec2 middle_m{0, 0};
    Vec2 velocity_mps{0, 0};
    double variance_m2ps2 = 0;  // variance of the velocity, per coordinate
    Vec2 at(double time_s) const { return middle_m + velocity_mps * (time_s - middle_s); }
  };

  const BallDetection& ball(int back) const { return frames_.detection(back).ball; }
  Line line_through(int newest_back, int oldest_back) const;
  Vec2 unexplained_change_mps(const Line& before, const Line& after) const;

  const FrameHistory& frames_;
  TouchParameters parameters_;
  int known_ = 0;             // detections since the restart, up to kUsed
  double former_excess_ = 0;  // ratio of change to threshold, one detection ago
  VelocityChange former_;     // the change one detection ago, without its frames
};

}  // namespace autoref::referee
