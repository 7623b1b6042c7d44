// The last frames of play, for whoever judges it in hindsight.
#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <cstdint>

#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// What is kept of a frame.
struct StoredFrame {
  struct Robot {
    RobotId id;
    Vec2 position_m{0, 0};
    Vec2 heading{1, 0};
  };
  double time_s = 0;
  bool has_ball = false;
  bool jumps =
      false;          // whether the ball's position is not to be compared with the detection before
  Vec2 ball_m{0, 0};  // where it was last seen, without one; the centre before it ever was
  double height_m = 0;                                            // of the lowest point
  boost::container::static_vector<Robot, 2 * kMaxRobots> robots;  // within a metre of the ball
};

// Frames by number. Numbers count from 0; the last kKept are kept, in memory of their own.
class FrameHistory {
 public:
  static constexpr int kKept = 256;  // 4 s of a 60 Hz camera, 2.5 s of one of 100 Hz

  void clear();

  // The next detection's `jumps` will be set.
  void lose_sight() { jumps_ = true; }

  // Takes in a frame; one that is not later than the one before is skipped.
  void push(const Frame& frame);

  bool empty() const { return newest_ < 0; }
  std::int64_t newest() const { return newest_; }
  // The first detection of the ball that is kept and not before `since_s`; a number after the
  // newest one where there is none.
  std::int64_t first_detection(double since_s) const;
  const StoredFrame& operator[](std::int64_t number) const {
    return kept_[static_cast<std::size_t>(number % kKept)];
  }

 private:
  std::array<StoredFrame, kKept> kept_;
  std::int64_t newest_ = -1;
  bool jumps_ = false;
};

}  // namespace autoref::referee
