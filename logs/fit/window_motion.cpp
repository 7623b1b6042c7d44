#include "logs/fit/window_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "soccer/geometry.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::logs {
namespace {

constexpr std::size_t kLeastHalf_frames = 3;
constexpr double kLeastSeenShare = 0.8;

// A worse fit shows a robot that was confused with another, or a crash.
constexpr double kWorstPositionFit_m = 15_mm;
constexpr double kWorstHeadingFit_rad = 0.15;

constexpr double kDirected_mps = 0.4;  // faster robots have a clear direction of motion
// Closer robots may push each other.
constexpr double kAloneWithin_m = 2 * kRobotRadius_m + 70_mm;

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

bool is_away_from_robots(const RecordedMotion& motion, std::size_t robot, std::size_t frame) {
  const Vec2 here_m = motion.robots[robot].sights[frame].position_m;
  for (std::size_t other = 0; other < motion.robots.size(); ++other) {
    const RobotSight& sight = motion.robots[other].sights[frame];
    if (other != robot && sight.is_known && (sight.position_m - here_m).norm() <= kAloneWithin_m)
      return false;
  }
  return true;
}

}  // namespace

std::size_t frames_in(double duration_s, const RecordedMotion& motion, std::size_t least) {
  return std::max(least, static_cast<std::size_t>(std::lround(duration_s / motion.interval_s)));
}

std::size_t half_window(double half_s, const RecordedMotion& motion) {
  return frames_in(half_s, motion, kLeastHalf_frames);
}

std::optional<WindowMotion> window_motion(const RecordedMotion& motion, std::size_t robot,
                                          std::size_t frame, double half_s) {
  const std::size_t half = half_window(half_s, motion);
  if (frame < half || frame + half >= motion.frames()) return std::nullopt;
  const double unit_s = static_cast<double>(half) * motion.interval_s;
  const auto sums = sums_around(motion, motion.robots[robot], frame, half, unit_s);
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

std::optional<Measured> speed_gain_mps2(const RecordedMotion& motion, std::size_t robot,
                                        std::size_t frame) {
  const auto now = window_motion(motion, robot, frame, kDriveHalf_s);
  if (!now || now->speed_mps.value <= kDirected_mps || !is_away_from_robots(motion, robot, frame))
    return std::nullopt;
  return now->gain_mps2;
}

}  // namespace autoref::logs
