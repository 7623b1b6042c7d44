// The history of recent frames of play.
//
// One bounded history serves all code that needs earlier frames: both touch detectors
// (online_touch_detector.hpp, retrospective_touch_detector.hpp), the order of touches
// (touch_history.hpp) and the rules. The referee owns it, restarts it when play starts and pushes
// each frame of play; all others only read it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

struct BallDetection {
  double time_s = 0;
  Vec2 position_m{0, 0};
  double height_m = 0;            // height of the ball's lowest point
  double height_deviation_m = 0;  // standard deviation of `height_m`; 0 if vision reports heights
  bool height_known = true;
  bool jumps = false;  // the tracker has just begun or stopped tracking the ball as flying
  // Time since the previous detection; 0 if the ball jumps or this is the first detection.
  double duration_s = 0;
  Vec2 velocity_mps{0, 0};  // mean over `duration_s`
};

struct StoredFrame {
  double time_s = 0;
  bool has_ball = false;
  BallDetection ball;  // the last detection before this frame, if this frame has no ball
  PerSide<SeenRobots> robots;
};

// Whether the robot is within a metre of the ball's last detection. Touches by robots farther away
// are neglected: at 60 Hz, a ball at 6 m/s would have to go undetected for ten frames to cover that
// distance.
bool is_near_ball(const StoredFrame& frame, const RobotObservation& robot);

// A ring buffer; nothing is allocated. Frame 0 is the one in which play started; the frames of play
// are counted from 1.
class FrameHistory {
 public:
  static constexpr int kKept = 256;  // 4 s at 60 Hz, 2.5 s at 100 Hz
  // Number of detections that can be looked up by their order.
  static constexpr int kDetections = 16;
  // How many frames and detections back the touch history and the rules can look: 0.15 s at 60 Hz.
  // This suffices because touches are reported within 0.1 s.
  static constexpr int kRecent = 10;

  FrameHistory();

  // Starts a new play in this frame, with the ball at rest at `ball_m`; nullopt if the ball has
  // never been seen.
  void restart(const Frame& frame, const std::optional<Vec2>& ball_m);

  // Makes the next detection a jump (`jumps`).
  void lose_sight() { jumps_ = true; }

  // Appends a frame of play, dropping the oldest one. Skips frames that are not later than the
  // newest one. `track` is the tracked ball, used for the uncertainty of a flying ball's height.
  void push(const Frame& frame, const std::optional<TrackedBall>& track = std::nullopt);

  std::int64_t newest() const { return newest_; }
  const StoredFrame& operator[](std::int64_t number) const {
    return kept_[static_cast<std::size_t>(number) % kKept];
  }

  // Detections of the ball since the restart, including the ball at rest.
  std::int64_t detections() const { return detections_; }
  // The frame of the `back`-th detection before the newest one; `back` must be below kDetections
  // and below detections().
  const StoredFrame& detection(int back) const { return (*this)[number_of_detection(back)]; }
  // The number of the first stored detection that is not before `since_s`; newest() + 1 if there is
  // none.
  std::int64_t first_detection(double since_s) const;

  // The `back`-th detection before the newest one; null unless it is one of the last kRecent of
  // this play, not counting the ball at rest.
  const BallDetection* ball(std::size_t back) const;

  // Of the detections that ball() can return, the newest one that is not after `time_s`, or the
  // oldest one if all are later; null if there are none. Positions between detections are not
  // interpolated, since a touch bends the path.
  const BallDetection* ball_before(double time_s) const;

  // The robots at `time_s`, interpolated linearly between the last kRecent frames. Outside that
  // range, it returns the robots in the nearest frame.
  PerSide<SeenRobots> robots_at(double time_s) const;

 private:
  std::int64_t number_of_detection(std::int64_t back) const {
    return detection_numbers_[static_cast<std::size_t>(detections_ - 1 - back) % kDetections];
  }
  StoredFrame& append(double time_s, const PerSide<SeenRobots>& robots);
  void add_detection(StoredFrame& frame);

  std::array<StoredFrame, kKept> kept_;
  std::int64_t newest_ = 0;
  std::array<std::int64_t, kDetections> detection_numbers_{};  // also a ring buffer
  std::int64_t detections_ = 0;
  bool jumps_ = false;
};

}  // namespace autoref::referee
