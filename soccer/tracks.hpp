// Robots and ball in motion: what a tracker makes of frames.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref {

struct TrackedRobot {
  int number = 0;
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};
  Vec2 velocity_mps{0, 0};
  double angular_velocity_radps = 0;
  bool is_seen = true;  // in the last frame; else where it was going
};

struct TrackedBall {
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  double height_m = 0;            // of the lowest point, as reported or estimated
  double height_deviation_m = 0;  // standard deviation; 0 where the height is reported
  bool is_height_known = true;    // false while vision cannot tell whether a kicked ball flies
};

using TrackedRobots = boost::container::static_vector<TrackedRobot, kMaxRobots>;

// The field as last known, in the frame of the frames it came from.
struct Tracks {
  std::int64_t frame = 0;           // number of the last frame
  double time_s = 0;                // when it was taken
  PerSide<TrackedRobots> robots;    // ordered by number
  std::optional<TrackedBall> ball;  // none before the ball was first seen
};

// The tracks seen from the other end: turned by 180 degrees, the sides swapped.
TrackedRobot mirrored(const TrackedRobot& robot);
TrackedBall mirrored(const TrackedBall& ball);

}  // namespace autoref
