// The motion of a robot, from the detections in a short window of time.
#pragma once

#include <cstddef>
#include <optional>

#include "logs/fit/estimate.hpp"
#include "logs/fit/recorded_motion.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {

// Halves of the windows in which quadratics are fitted: long enough to average out the noise, and
// shorter than the robots' manoeuvres.
inline constexpr double kSpeedHalf_s = 60_ms;
inline constexpr double kDriveHalf_s = 130_ms;  // for accelerations

// The motion in the middle of a window, with the standard deviations that noise causes.
struct WindowMotion {
  Measured speed_mps;
  Measured gain_mps2;  // of speed; negative when braking
  Measured angular_speed_radps;
  Measured angular_acceleration_radps2;
};

// `duration_s` in frames, at least `least`.
std::size_t frames_in(double duration_s, const RecordedMotion& motion, std::size_t least);

// The number of frames before and after the middle of a window.
std::size_t half_window(double half_s, const RecordedMotion& motion);

// The motion around a frame. Returns nullopt if vision did not follow the robot there, or if the
// frame is less than half_window() from the first or last one.
std::optional<WindowMotion> window_motion(const RecordedMotion& motion, std::size_t robot,
                                          std::size_t frame, double half_s);

// By how much the robot gains speed around a frame; negative when braking. Returns nullopt if
// window_motion() does, if the robot is too slow for a clear direction of motion, or if another
// robot may push it.
std::optional<Measured> speed_gain_mps2(const RecordedMotion& motion, std::size_t robot,
                                        std::size_t frame);

}  // namespace autoref::logs
