#include "logs/fit/robot_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::logs {
namespace {

// Longer than the robots keep doing the same, so that blocks are nearly independent.
constexpr double kReachedBlock_s = 20;

// Halves of the windows in which quadratics are fitted: long enough to average out the noise, and
// shorter than the robots' manoeuvres.
constexpr double kSpeedHalf_s = 60_ms;
constexpr double kTurnHalf_s = 90_ms;
constexpr double kDriveHalf_s = 130_ms;
constexpr std::size_t kLeastHalf_frames = 3;
constexpr double kLeastSeenShare = 0.8;

// A worse fit shows a robot that was confused with another, or a crash.
constexpr double kWorstPositionFit_m = 15_mm;
constexpr double kWorstHeadingFit_rad = 0.15;

constexpr double kDriving_mps = 0.3;
constexpr double kDirected_mps = 0.4;    // faster robots have a clear direction of motion
constexpr double kChanging_mps2 = 0.4;   // smaller changes of speed are mostly noise
constexpr double kTurning_radps2 = 5.0;  // slower changes are mostly noise
// Closer robots may push each other.
constexpr double kAloneWithin_m = 2 * kRobotRadius_m + 70_mm;

constexpr double kSpeedQuantile = 0.999;
constexpr double kAccelerationQuantile = 0.98;
constexpr double kBrakingQuantile = 0.99;
constexpr double kTurnQuantile = 0.9995;
constexpr double kAngularAccelerationQuantile = 0.98;

// The motion in the middle of a window, with the standard deviations that noise causes.
struct WindowMotion {
  Measured speed_mps;
  Measured gain_mps2;  // of speed; negative when braking
  Measured angular_speed_radps;
  Measured angular_acceleration_radps2;
};

// Adds the amount of what was measured, if it is more than `least`. One standard deviation is
// subtracted, because noise would make high quantiles too high.
void add_above(double least, const Measured& measured, BlockHistogram& histogram) {
  const double amount = std::abs(measured.value) - measured.deviation;
  if (amount > least) histogram.add(amount);
}

// The sums of a least-squares fit of quadratics to x, y and heading over time.
struct QuadraticSums {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d right = Eigen::Matrix3d::Zero();  // columns: x, y, heading
  Eigen::Vector3d squares{0, 0, 0};
  std::size_t count = 0;

  void add(double time, const Eigen::Vector3d& values) {
    const Eigen::Vector3d powers(1, time, time * time / 2);
    normal += powers * powers.transpose();
    right += powers * values.transpose();
    squares += values.cwiseAbs2();
    ++count;
  }
};

// The sums around a frame, with times from there in units of `unit_s`. Returns nullopt if the
// window has a gap or spans a change of cameras, which are a few millimetres apart.
std::optional<QuadraticSums> sums_around(const RecordedMotion& motion, const RobotMotion& robot,
                                         std::size_t frame, std::size_t half, double unit_s) {
  const std::size_t first = frame - half;
  const std::size_t last = frame + half;
  const double full_s = static_cast<double>(2 * half) * motion.interval_s;
  if (motion.times_s[last] - motion.times_s[first] > full_s + 1.5 * motion.interval_s)
    return std::nullopt;
  QuadraticSums sums;
  const RobotSight* origin = nullptr;
  for (std::size_t f = first; f <= last; ++f) {
    const RobotSight& sight = robot.sights[f];
    if (!sight.is_seen) continue;
    if (!origin) origin = &sight;
    if (sight.camera != origin->camera) return std::nullopt;
    const Vec2 moved_m = sight.position_m - origin->position_m;
    sums.add((motion.times_s[f] - motion.times_s[frame]) / unit_s,
             {moved_m.x(), moved_m.y(), sight.heading_rad - origin->heading_rad});
  }
  if (static_cast<double>(sums.count) < kLeastSeenShare * static_cast<double>(2 * half + 1))
    return std::nullopt;
  return sums;
}

// The motion around a frame, or nullopt if vision did not follow the robot there.
std::optional<WindowMotion> motion_around(const RecordedMotion& motion, const RobotMotion& robot,
                                          std::size_t frame, std::size_t half) {
  const double unit_s = static_cast<double>(half) * motion.interval_s;
  const auto sums = sums_around(motion, robot, frame, half, unit_s);
  if (!sums) return std::nullopt;
  const Eigen::Matrix3d inverse = sums->normal.inverse();
  const Eigen::Matrix3d fitted = inverse * sums->right;
  const Eigen::Vector3d residuals =
      (sums->squares - fitted.cwiseProduct(sums->right).colwise().sum().transpose()).cwiseMax(0.0);
  const auto count = static_cast<double>(sums->count);
  if (residuals.head<2>().maxCoeff() > count * square(kWorstPositionFit_m) ||
      residuals[2] > count * square(kWorstHeadingFit_rad))
    return std::nullopt;
  // Standard deviations of velocity and acceleration, for unit noise.
  const double noisy_per_s = std::sqrt(inverse(1, 1)) / unit_s;
  const double noisy_per_s2 = std::sqrt(inverse(2, 2)) / square(unit_s);
  const double noise_m = std::sqrt(residuals.head<2>().sum() / (2 * (count - 3)));
  const double noise_rad = std::sqrt(residuals[2] / (count - 3));
  const Vec2 velocity_mps = fitted.row(1).head<2>().transpose() / unit_s;
  const Vec2 acceleration_mps2 = fitted.row(2).head<2>().transpose() / square(unit_s);
  return WindowMotion{
      .speed_mps = {velocity_mps.norm(), noise_m * noisy_per_s},
      .gain_mps2 = {acceleration_mps2.dot(direction_of(velocity_mps, {0, 0})),
                    noise_m * noisy_per_s2},
      .angular_speed_radps = {fitted(1, 2) / unit_s, noise_rad * noisy_per_s},
      .angular_acceleration_radps2 = {fitted(2, 2) / square(unit_s), noise_rad * noisy_per_s2}};
}

bool is_away_from_robots(const RecordedMotion& motion, std::size_t robot, std::size_t frame) {
  const Vec2 here_m = motion.robots[robot].sights[frame].position_m;
  for (std::size_t other = 0; other < motion.robots.size(); ++other) {
    const RobotSight& sight = motion.robots[other].sights[frame];
    if (other != robot && sight.is_known && (sight.position_m - here_m).norm() <= kAloneWithin_m)
      return false;
  }
  return true;
}

std::size_t frames_in(double duration_s, const RecordedMotion& motion, std::size_t least) {
  return std::max(least, static_cast<std::size_t>(std::lround(duration_s / motion.interval_s)));
}

// The number of frames before and after the middle of a window.
std::size_t half_window_of(double half_s, const RecordedMotion& motion) {
  return frames_in(half_s, motion, kLeastHalf_frames);
}

}  // namespace

void RobotFit::start_block() {
  for (BlockHistogram* histogram : {&speed_mps_, &acceleration_mps2_, &braking_mps2_,
                                    &angular_speed_radps_, &angular_acceleration_radps2_})
    histogram->start_block();
}

void RobotFit::add(const RecordedMotion& motion, Side side) {
  const std::size_t longest_half = half_window_of(kDriveHalf_s, motion);
  const std::size_t block = frames_in(kReachedBlock_s, motion, 1);
  for (std::size_t frame = longest_half; frame + longest_half < motion.frames(); ++frame) {
    if ((frame - longest_half) % block == 0) start_block();
    for (std::size_t robot = 0; robot < motion.robots.size(); ++robot)
      if (motion.robots[robot].id.side == side) add_frame(motion, robot, frame);
  }
}

void RobotFit::add_frame(const RecordedMotion& motion, std::size_t robot, std::size_t frame) {
  const auto fit = [&](double half_s) {
    return motion_around(motion, motion.robots[robot], frame, half_window_of(half_s, motion));
  };
  if (const auto now = fit(kSpeedHalf_s)) {
    add_above(kDriving_mps, now->speed_mps, speed_mps_);
    add_above(0, now->angular_speed_radps, angular_speed_radps_);
  }
  if (const auto now = fit(kTurnHalf_s))
    add_above(kTurning_radps2, now->angular_acceleration_radps2, angular_acceleration_radps2_);
  const auto now = fit(kDriveHalf_s);
  if (now && now->speed_mps.value > kDirected_mps && is_away_from_robots(motion, robot, frame))
    add_above(kChanging_mps2, now->gain_mps2,
              now->gain_mps2.value > 0 ? acceleration_mps2_ : braking_mps2_);
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
