// A tracker's output: robots and ball with their velocities.
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
  // Whether it was seen in the most recent frame; otherwise it is extrapolated.
  bool is_seen = true;
};

struct TrackedBall {
  Vec2 position_m{0, 0};
  Vec2 velocity_mps{0, 0};
  double height_m = 0;            // height of the lowest point, reported or estimated
  double height_deviation_m = 0;  // standard deviation; 0 if the height is reported
  bool is_height_known = true;    // false while the ball may or may not be in the air
};

using TrackedRobots = boost::container::static_vector<TrackedRobot, kMaxRobots>;

// The last known state of the field, in the coordinates of the frames.
struct Tracks {
  std::int64_t frame = 0;           // number of the most recent frame
  double time_s = 0;                // capture time of that frame
  PerSide<TrackedRobots> robots;    // ordered by number
  std::optional<TrackedBall> ball;  // nullopt until the ball has been seen
};

// The tracks as seen from the other end, that is, rotated by 180 degrees.
TrackedRobot mirrored(const TrackedRobot& robot);
TrackedBall mirrored(const TrackedBall& ball);

}  // namespace autoref
