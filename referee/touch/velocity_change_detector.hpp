// Detects changes of the ball's velocity that noise hides between two frames but not over several,
// and decides which robot caused them.
//
// A two-window change detector (Gustafsson 2000; docs/touch-detection.md): least-squares lines are
// fitted to the five detections that end with each detection and to the five that begin with it. If
// their velocities differ by more than friction and noise explain, and the difference is at its
// peak, the ball hit something there. The change is reported five detections later.
#pragma once

#include <optional>

#include "referee/referee_configuration.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

struct VelocityChange {
  // The detections on either side of the change; valid until the next frame.
  const StoredFrame* before = nullptr;
  const StoredFrame* after = nullptr;
  double since_s = 0;  // time of the oldest detection that the change was computed from
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

  // Processes the newest detection in the history. Returns the velocity change that this detection
  // confirms, if any.
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

// Which of several candidates touched the ball, as far as that can be decided.
struct Verdict {
  bool is_touch = false;         // whether a robot touched the ball at all
  std::optional<Side> side;      // nullopt if unknown
  std::optional<RobotId> robot;  // nullopt if unknown, or one of several of that side
  // The best candidate of the other side, or of the same side if the other has none.
  std::optional<RobotId> runner_up;
  double gap_m = 0;
  double share = 0;
};

// Candidates that explain the velocity change come before those that do not, unless the ball is
// pinned against one of the latter. If several are equally good, the side that is nearer to the
// ball by `lead_m` touched it; if neither side is, the toucher's side is unknown. If a goal is
// about as near as the best robot, the touch is unknown, unless that robot's side touched the ball
// before (`had_it`); if a goal is clearly nearer, there was no touch.
Verdict attribute_touch(const Candidates& candidates, double gap_to_goals_m,
                        std::optional<Side> had_it, const TouchParameters& parameters);

}  // namespace autoref::referee
