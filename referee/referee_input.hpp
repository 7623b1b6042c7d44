// What the referee sees and is bound by in one frame: the input of its rules and of its machine.
#pragma once

#include <optional>

#include "referee/configuration.hpp"
#include "referee/decision.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/side.hpp"
#include "soccer/team_requests.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

// The ball as last seen. A frame without a ball changes nothing.
struct BallSight {
  Vec2 position_m{0, 0};
  Vec2 before_m{0, 0};  // at the detection before: the paper's b'
  double height_m = 0;  // of the lowest point; Deviation D15: unknown counts as 0
  bool height_known = true;
};

struct RefereeInput {
  const Configuration& configuration;
  const Frame& frame;
  const std::optional<BallSight>& ball;  // none before the ball was first seen
  const LastTouch& last_touch;           // the paper's c
  const Tracks& tracks;                  // with velocities, and robots that this frame missed
  const PerSide<TeamRequests>& requests;

  double time_s() const { return frame.time_s; }
};

// Whether `duration_s` has passed since `since_s`. Times are quotients of frame numbers, so that
// their differences are off by rounding; a microsecond is less than any camera's frame.
inline bool has_passed(double since_s, double duration_s, double now_s) {
  return now_s - since_s >= duration_s - 1e-6;
}

}  // namespace autoref::referee
