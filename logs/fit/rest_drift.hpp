// The slowly changing part of the noise of detections, which resting objects show.
#pragma once

#include <vector>

#include "logs/fit/recorded_motion.hpp"

namespace autoref::logs {

// For each rest of at least three seconds: the variance along x and y, in square metres, of the
// object's mean positions in windows of a quarter of a second, minus the variance that they have
// from noise that is independent in each frame. Without any drift, the values scatter around zero.
std::vector<double> ball_drifts_m2(const RecordedMotion& motion);
std::vector<double> robot_drifts_m2(const RecordedMotion& motion, const RobotMotion& robot);

}  // namespace autoref::logs
