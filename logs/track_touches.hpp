// Touches of the ball in a recorded game, as a simulated world would report them, estimated from
// the referee's touch detector and tracks.
//
// The detector reports the last touch, often a few frames late, and may revise it. The touches are
// therefore taken when later frames have been seen, which also show the ball's velocity after the
// touch. A touch counts as a kick if the ball leaves the robot's front faster than a passive hull
// could send it.
//
// Noise hides soft touches from the detector, which only reports what it is sure of. Two kinds are
// therefore added. If vision is noisy, a ball that stays at a robot's hull and moves with it is
// touched by that robot in each frame. If a restart is taken and the detector reports no touch, the
// robot that was nearest to the ball took it.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "logs/tracked_frame.hpp"
#include "referee/decision.hpp"
#include "referee/referee.hpp"
#include "sim/world.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "tracking/tracker.hpp"

namespace autoref::logs {

class TrackTouches {
 public:
  // `noise`: the vision noise.
  explicit TrackTouches(const tracking::VisionNoise& noise) : is_noisy_(noise.ball_m > 0) {}

  // Takes note of the touch that the referee reports in its newest frame, `frame`.
  void update(const referee::AutoRef& referee, const TrackedFrame& frame);

  // Removes the touches up to the first of `frames` and returns them in order of time. `before` is
  // the frame before it, and the other frames should cover kLookAhead_s. The touches' frame numbers
  // are not set. A touch by an unknown side becomes a simultaneous touch by the nearest robots of
  // both sides.
  std::vector<sim::Touch> take(const std::optional<TrackedFrame>& before,
                               const std::deque<TrackedFrame>& frames);

 private:
  struct Report {
    referee::LastTouch touch;
    double reported_s = 0;  // time of the frame in which it was first reported
  };

  void note(const referee::LastTouch& touch, double now_s);
  void add(RobotId robot, double time_s);
  void note_held(const TrackedFrame& frame);
  void note_restart(const referee::AutoRef& referee, const TrackedFrame& frame);
  Report take_oldest();
  std::optional<double> next_s() const;
  std::vector<sim::Touch> touches_for(const Report& report,
                                      const std::optional<TrackedFrame>& before,
                                      const std::deque<TrackedFrame>& frames) const;

  bool is_noisy_;
  std::deque<Report> waiting_;  // in order of time; at most one is added per frame
  referee::LastTouch latest_;

  std::deque<Report> added_;  // touches that the detector does not report, in order of time
  std::optional<RobotId> holder_;
  double held_since_s_ = 0;
  // The robot nearest to a ball that lies ready for a restart.
  std::optional<RobotId> kicker_;
  Vec2 rest_m_{0, 0};
  double at_rest_s_ = 0;  // when the ball last was there
};

}  // namespace autoref::logs
