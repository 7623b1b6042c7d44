#include "logs/fit/robot_fit.hpp"

#include <algorithm>
#include <cmath>

#include "logs/fit/window_motion.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

// Longer than the robots keep doing the same, so that blocks are nearly independent.
constexpr double kReachedBlock_s = 20;

constexpr double kTurnHalf_s = 90_ms;  // of a window for angular accelerations

constexpr double kDriving_mps = 0.3;
constexpr double kChanging_mps2 = 0.4;   // smaller changes of speed are mostly noise
constexpr double kTurning_radps2 = 5.0;  // slower changes are mostly noise

constexpr double kSpeedQuantile = 0.999;
constexpr double kAccelerationQuantile = 0.98;
constexpr double kBrakingQuantile = 0.99;
constexpr double kTurnQuantile = 0.9995;
constexpr double kAngularAccelerationQuantile = 0.98;

// Adds the amount of what was measured, if it is more than `least`. One standard deviation is
// subtracted, because noise would make high quantiles too high.
void add_above(double least, const Measured& measured, BlockHistogram& histogram) {
  const double amount = std::abs(measured.value) - measured.deviation;
  if (amount > least) histogram.add(amount);
}

}  // namespace

void RobotFit::start_block() {
  for (BlockHistogram* histogram : {&speed_mps_, &acceleration_mps2_, &braking_mps2_,
                                    &angular_speed_radps_, &angular_acceleration_radps2_})
    histogram->start_block();
}

void RobotFit::add(const RecordedMotion& motion, Side side) {
  const std::size_t longest_half = half_window(kDriveHalf_s, motion);
  const std::size_t block = frames_in(kReachedBlock_s, motion, 1);
  for (std::size_t frame = longest_half; frame + longest_half < motion.frames(); ++frame) {
    if ((frame - longest_half) % block == 0) start_block();
    for (std::size_t robot = 0; robot < motion.robots.size(); ++robot)
      if (motion.robots[robot].id.side == side) add_frame(motion, robot, frame);
  }
}

void RobotFit::add_frame(const RecordedMotion& motion, std::size_t robot, std::size_t frame) {
  if (const auto now = window_motion(motion, robot, frame, kSpeedHalf_s)) {
    add_above(kDriving_mps, now->speed_mps, speed_mps_);
    add_above(0, now->angular_speed_radps, angular_speed_radps_);
  }
  if (const auto now = window_motion(motion, robot, frame, kTurnHalf_s))
    add_above(kTurning_radps2, now->angular_acceleration_radps2, angular_acceleration_radps2_);
  if (const auto gain_mps2 = speed_gain_mps2(motion, robot, frame))
    add_above(kChanging_mps2, *gain_mps2,
              gain_mps2->value > 0 ? acceleration_mps2_ : braking_mps2_);
}

Estimate RobotFit::speed_mps() const { return speed_mps_.quantile(kSpeedQuantile); }

Estimate RobotFit::acceleration_mps2() const {
  return acceleration_mps2_.quantile(kAccelerationQuantile);
}

Estimate RobotFit::braking_mps2() const { return braking_mps2_.quantile(kBrakingQuantile); }

Estimate RobotFit::angular_speed_radps() const {
  return angular_speed_radps_.quantile(kTurnQuantile);
}

Estimate RobotFit::angular_acceleration_radps2() const {
  return angular_acceleration_radps2_.quantile(kAngularAccelerationQuantile);
}

}  // namespace autoref::logs
