// The referee's input in one frame, for its rules and its machine.
#pragma once

#include <optional>

#include "referee/decision.hpp"
#include "referee/referee_configuration.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"
#include "soccer/tracks.hpp"

namespace autoref::referee {

class FrameHistory;  // see touch/frame_history.hpp

// The ball as last seen. A frame in which vision sees no ball leaves it unchanged.
struct BallSight {
  Vec2 position_m{0, 0};
  Vec2 before_m{0, 0};  // in the previous detection: the paper's b'
  double height_m = 0;  // height of the lowest point; Deviation D15: an unknown height counts as 0
  bool height_known = true;
};

struct RefereeInput {
  const Configuration& configuration;
  const Frame& frame;
  const std::optional<BallSight>& ball;  // nullopt until vision first sees the ball
  const LastTouch& last_touch;           // the paper's c
  const Tracks& tracks;  // tracked objects with velocities, including robots missing from the frame
  const PerSide<TeamRequests>& requests;
  const FrameHistory& frames;  // frames of the current play so far, including this frame
  // The person's last signal, and AutoRef's own last call in the current play. Set only during
  // steps of the transitions in person/.
  const RefereeSignal* given = nullptr;
  const Finding* own_call = nullptr;

  double time_s() const { return frame.time_s; }
};

// Whether `duration_s` has passed since `since_s`. Times are frame numbers divided by the rate, so
// their differences have rounding errors; the tolerance is one microsecond, less than any frame
// period.
inline bool has_passed(double since_s, double duration_s, double now_s) {
  return now_s - since_s >= duration_s - 1e-6;
}

}  // namespace autoref::referee
