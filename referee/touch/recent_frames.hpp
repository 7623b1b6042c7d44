// The last few frames of play: touches of the ball are told late, and judged by what was then.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <optional>

#include "referee/referee_input.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref::referee {

// The ball in one frame.
struct RecentBall {
  double time_s = 0;
  Vec2 position_m{0, 0};
  double height_m = 0;            // of the lowest point
  double height_deviation_m = 0;  // standard deviation; 0 where vision reports heights
  bool height_known = true;
};

class RecentFrames {
 public:
  // 0.15 s of a 60 Hz camera; the latest touches are told after 0.1 s.
  static constexpr std::size_t kKept = 10;

  void add(const RefereeInput& input);

  // The `back`-th detection of the ball before the newest one, or null.
  const RecentBall* ball(std::size_t back) const;

  // The newest detection of the ball not after that time, else the oldest; null without any. A
  // touch changes the ball's way, so that places between detections are not known by their mean.
  const RecentBall* ball_before(double time_s) const;

  // The robots at that time, moving evenly between frames; before and after them as in the
  // nearest one.
  PerSide<SeenRobots> robots_at(double time_s) const;

 private:
  struct StoredFrame {
    double time_s = 0;
    PerSide<SeenRobots> robots;
  };

  boost::container::static_vector<StoredFrame, kKept> stored_;  // the oldest first
  boost::container::static_vector<RecentBall, kKept> balls_;
};

}  // namespace autoref::referee
