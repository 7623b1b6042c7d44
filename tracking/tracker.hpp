// Estimates positions and velocities from individual frames and extrapolates them through short
// gaps.
#pragma once

#include <array>
#include <limits>

#include "soccer/frame.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"
#include "soccer/units.hpp"
#include "tracking/ball_tracker.hpp"
#include "tracking/motion_filter.hpp"

namespace autoref::tracking {

// Vision noise as standard deviations, measured on stationary objects.
struct VisionNoise {
  double ball_m = 0;
  double robot_m = 0;
  double robot_rad = 0;
};

// One robot's motion through a sequence of detections.
class RobotTracker {
 public:
  RobotTracker() : RobotTracker(VisionNoise{}) {}
  explicit RobotTracker(const VisionNoise& noise);

  void start(const RobotObservation& seen);
  void predict(double duration_s);
  void correct(const RobotObservation& seen, double duration_s);

  const TrackedRobot& robot() const { return robot_; }

 private:
  void publish();

  MotionFilter<2> position_;
  MotionFilter<1> turn_;  // its position is the angle relative to robot_.heading
  TrackedRobot robot_;
};

// Turns a sequence of frames into tracks. Feed it frames in order; repeating a frame has no effect.
// Velocities come from a Kalman filter. An unseen robot keeps its velocity for 0.5 s and is then
// dropped; for the ball, see ball_tracker.hpp.
class Tracker {
 public:
  static constexpr double kForgetRobotAfter_s = 500_ms;

  explicit Tracker(const VisionNoise& noise = {});

  const Tracks& update(const Frame& frame);
  const Tracks& tracks() const { return tracks_; }

  // Discards all tracks, as if no frame had been seen.
  void begin_afresh() { *this = Tracker(noise_); }

 private:
  static constexpr double kNever_s = -std::numeric_limits<double>::infinity();

  struct Known {
    RobotTracker robot;
    double seen_s = kNever_s;  // time of the last detection
  };

  bool is_known(const Known& known) const;
  void see_robots(const SeenRobots& seen, std::array<Known, kMaxRobots>& all, double duration_s);

  VisionNoise noise_;
  PerSide<std::array<Known, kMaxRobots>> known_;
  BallTracker ball_;
  Tracks tracks_;
  bool has_seen_frame_ = false;
};

}  // namespace autoref::tracking
