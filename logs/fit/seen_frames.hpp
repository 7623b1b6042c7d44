// What all cameras of a log saw at about the same time, and the motion that such frames show.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "logs/fit/recorded_motion.hpp"
#include "soccer/frame.hpp"
#include "soccer/geometry.hpp"

namespace autoref::logs {

struct SeenBall {
  Vec2 position_m;
  double time_s;
  std::uint32_t camera;
};

struct SeenRobot {
  RobotId id;
  Vec2 position_m;
  double heading_rad;
  double time_s;
  std::uint32_t camera;
};

struct SeenFrame {
  double first_s = 0;  // time of the earliest capture
  double time_s = 0;   // of the latest one
  bool is_running = true;
  std::map<std::uint32_t, double> captures_s;  // by camera
  std::vector<SeenBall> balls;
  std::vector<SeenRobot> robots;
};

// The motion in at least four frames in increasing order of time. Its `field`, `cameras` and
// `has_heights` keep their defaults.
RecordedMotion motion_of(const std::vector<SeenFrame>& frames);

}  // namespace autoref::logs
