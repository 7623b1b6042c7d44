// What vision reports once per camera frame: the referee's and the teams' only source.
#pragma once

#include <boost/container/static_vector.hpp>
#include <cstdint>
#include <optional>

#include "soccer/geometry.hpp"
#include "soccer/side.hpp"

namespace autoref {

struct RobotObservation {
  int number = 0;
  Vec2 position_m{0, 0};
  Vec2 heading{1, 0};  // unit vector; a robot's front points along it
};

// Where a camera hangs.
struct CameraPosition {
  Vec2 position_m{0, 0};
  double height_m = 4;  // above the carpet (Laws 2014, section on vision: 4 m)
};

// Where vision reports no height, `position_m` is the place on the carpet that the camera sees the
// ball before: a flying ball appears farther from the camera than it is.
struct BallObservation {
  Vec2 position_m{0, 0};
  std::optional<double> height_m;  // of the ball's lowest point; none where vision cannot tell
  CameraPosition seen_from{};      // means nothing where the height is reported
};

// Seen robots of a side, ordered by number.
using SeenRobots = boost::container::static_vector<RobotObservation, kMaxRobots>;

// One frame of the field. Positions are in metres, in the field's frame (field.hpp).
struct Frame {
  std::int64_t number = 0;  // counts from 0 at the camera's rate
  double time_s = 0;        // number / rate, never accumulated
  PerSide<SeenRobots> robots;
  std::optional<BallObservation> ball;  // none where no camera sees it
};

// Whether every number in the frame is finite.
bool is_finite(const Frame& frame);

// The frame without what is not finite: such a robot or ball was not seen, such a height is
// unknown, such a camera hangs above the ball.
Frame finite_part(const Frame& frame);

// The same frame seen from the other end: turned by 180 degrees, the sides swapped.
Frame mirrored(const Frame& frame);

}  // namespace autoref
