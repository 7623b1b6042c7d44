// What vision reports for one camera frame: the only input of the referee and the teams.
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
  Vec2 heading{1, 0};  // unit vector towards the robot's front
};

// Where a camera is mounted, and how old its part of a frame is.
struct CameraPosition {
  Vec2 position_m{0, 0};
  double height_m = 4;  // above the carpet (Laws 2014, section on vision: 4 m)
  double age_s = 0;     // of its capture at the frame's time; 0 if read from a log
};

// The ball as vision reports it. Without a height, `position_m` is the point on the carpet where
// the camera sees the ball, so that a flying ball appears to be farther from the camera than it is.
struct BallObservation {
  Vec2 position_m{0, 0};
  std::optional<double> height_m;  // height of the ball's lowest point; nullopt if not reported
  CameraPosition seen_from{};      // unused if the height is reported
};

// Detected robots of one side, ordered by number.
using SeenRobots = boost::container::static_vector<RobotObservation, kMaxRobots>;

// One frame of the whole field. Positions are in metres, in field coordinates (field.hpp).
struct Frame {
  std::int64_t number = 0;  // counts from 0 at the camera's rate
  double time_s = 0;        // number / rate, never accumulated
  PerSide<SeenRobots> robots;
  std::optional<BallObservation> ball;  // nullopt if no camera sees it
};

// Detections that vision reports in addition to a frame: balls and robots that a reader of its
// packets would discard (league/detection_merger.hpp).
struct OtherDetections {
  boost::container::static_vector<BallObservation, 8> balls;
  PerSide<SeenRobots> robots;

  bool is_empty() const {
    return balls.empty() && robots[Side::kWest].empty() && robots[Side::kEast].empty();
  }
};

// Whether every number in the frame is finite.
bool is_finite(const Frame& frame);

// The frame without its non-finite values: a non-finite robot or ball counts as unseen, a
// non-finite height as unknown, and a camera at a non-finite position as directly above the ball.
Frame finite_part(const Frame& frame);

// The frame rotated by 180 degrees about the field's centre.
Frame rotated(Frame frame);
OtherDetections rotated(OtherDetections others);

// The frame seen from the other end: rotated by 180 degrees, with the sides swapped.
Frame mirrored(const Frame& frame);

}  // namespace autoref
