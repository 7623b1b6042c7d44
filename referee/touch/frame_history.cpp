#include "referee/touch/frame_history.hpp"

#include <algorithm>

namespace autoref::referee {
namespace {

// A robot that was farther from the ball's last detection than this did not touch it since: the
// ball goes 0.1 m in a frame, and 1 m while it is hidden for ten.
constexpr double kKeptAround_m = 1.0;

}  // namespace

void FrameHistory::clear() {
  newest_ = -1;
  jumps_ = false;
}

void FrameHistory::push(const Frame& frame) {
  if (!empty() && !(frame.time_s > (*this)[newest_].time_s)) return;
  const Vec2 last_m = empty() ? Vec2(0, 0) : (*this)[newest_].ball_m;
  ++newest_;
  StoredFrame& now = kept_[static_cast<std::size_t>(newest_ % kKept)];
  now.time_s = frame.time_s;
  now.has_ball = frame.ball.has_value();
  now.jumps = now.has_ball && jumps_;
  now.ball_m = frame.ball ? frame.ball->position_m : last_m;
  now.height_m = frame.ball ? frame.ball->height_m.value_or(0.0) : 0.0;
  if (now.has_ball) jumps_ = false;
  now.robots.clear();
  for (const Side side : kSides) {
    for (const RobotObservation& robot : frame.robots[side]) {
      const double away2_m2 = (robot.position_m - now.ball_m).squaredNorm();
      if (away2_m2 > kKeptAround_m * kKeptAround_m) continue;
      now.robots.push_back({{side, robot.number}, robot.position_m, robot.heading});
    }
  }
}

std::int64_t FrameHistory::first_detection(double since_s) const {
  std::int64_t number = std::max<std::int64_t>(0, newest_ - kKept + 1);
  while (number <= newest_ && !((*this)[number].has_ball && (*this)[number].time_s >= since_s)) {
    ++number;
  }
  return number;
}

}  // namespace autoref::referee
