// A frame of a recorded game as a simulated world would be, estimated from the referee's tracks,
// and what such frames show about a touch of the ball.
#pragma once

#include <deque>
#include <optional>

#include "referee/referee.hpp"
#include "sim/world.hpp"
#include "soccer/geometry.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {

// How many seconds of frames after a touch are used. The detector reports soft touches under noise
// five detections late, and the tracker detects a chip kick within 0.3 s.
inline constexpr double kLookAhead_s = 400_ms;

// A judged frame. The world is estimated from the tracks; its frame number is not set.
struct TrackedFrame {
  double time_s = 0;
  sim::WorldState world;
  std::optional<Vec2> ball_m;  // the ball's detection in this frame
};

// The newest frame of the referee; nullopt before the ball has been seen.
std::optional<TrackedFrame> tracked_frame(const referee::AutoRef& referee);

// The ball's motion right after a touch.
struct BallAfterTouch {
  Vec2 velocity_mps{0, 0};
  double vertical_mps = 0;  // 0 unless the ball was chipped
};

// Estimates it from the frames that follow the touch at `touched_s`, which happened at `from_m`,
// until the next touch at `next_s`. `frames` must not be empty; its first frame is the first one
// after the touch.
BallAfterTouch ball_after_touch(const std::deque<TrackedFrame>& frames, const Vec2& from_m,
                                double touched_s, double next_s);

// Whether the robot's kicker sent the ball away: the ball, at `ball_m`, leaves the robot's front at
// `after_mps`, and faster than a bounce of a ball that arrives at `before_mps`.
bool is_kick(const sim::RobotState& robot, const Vec2& ball_m, const Vec2& before_mps,
             const Vec2& after_mps);

}  // namespace autoref::logs
