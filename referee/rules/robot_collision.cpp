#include "referee/rules/robot_collision.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/constant_acceleration_fit.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// Distance between the centres of robots in contact.
constexpr double kCylinders_m = 2 * kRobotRadius_m;

constexpr double kFittedFor_s = 200_ms;
constexpr int kFewestDetections = 4;
constexpr double kFasterThanAnyRobot_mps = 15;  // at higher speeds the robot was relocated
constexpr double kUnknownJerk_mps3 = 30;
// Prior for the acceleration: robots mostly brake before they run into something.
constexpr double kBraking_mps2 = 2;
constexpr double kBrakingDeviation_mps2 = 2;
constexpr double kFullBraking_mps = 0.5;          // slower robots have less speed to lose
constexpr double kCollisionRounding_m = 0.01e-3;  // position error of a noise-free camera
constexpr int kContactSteps = 16;                 // samples of the path between two frames

// Frames after the contact whose distances are extrapolated back to it.
constexpr std::size_t kFramesAfter = 3;
// Largest extrapolated distance between robots in contact, in excess of the distance at which their
// cylinders touch, and the number of standard deviations of a robot's position to be added to it.
constexpr double kContactError_m = 1_mm;
constexpr double kContactDeviations = 2.5;

// The first sample of the fit that ends with path[last]. It is at most kFittedFor_s before
// path[last], and after the robot was last relocated.
std::size_t first_sample(std::span<const PairSample> path, std::size_t last, Side side) {
  std::size_t first = last;
  const PairSample* later = nullptr;
  for (std::size_t i = last + 1; i-- > 0;) {
    if (path[last].time_s - path[i].time_s > kFittedFor_s) break;
    first = i;
    if (!path[i].position_m[side]) continue;
    if (later != nullptr) {
      const double moved_m = (*later->position_m[side] - *path[i].position_m[side]).norm();
      if (moved_m > kFasterThanAnyRobot_mps * (later->time_s - path[i].time_s)) return i + 1;
    }
    later = &path[i];
  }
  return first;
}

// The robot's motion at the time of path[last]; nullopt if vision saw it in too few frames.
std::optional<ConstantAcceleration> motion_before(std::span<const PairSample> path,
                                                  std::size_t last, Side side,
                                                  const tracking::VisionNoise& noise) {
  const double now_s = path[last].time_s;
  const std::size_t first = first_sample(path, last, side);
  const auto is_seen = [side](const PairSample& s) { return s.position_m[side].has_value(); };
  const auto window = path.subspan(first, last + 1 - first);
  if (std::count_if(window.begin(), window.end(), is_seen) < kFewestDetections) {
    return std::nullopt;
  }
  const PairSample& oldest = *std::find_if(window.begin(), window.end(), is_seen);
  const PairSample& newest = *std::find_if(window.rbegin(), window.rend(), is_seen);
  const Vec2 mean_mps =
      (*newest.position_m[side] - *oldest.position_m[side]) / (newest.time_s - oldest.time_s);
  const double braking_mps2 = kBraking_mps2 / std::max(mean_mps.norm(), kFullBraking_mps);
  ConstantAccelerationFit fit(-braking_mps2 * mean_mps, kBrakingDeviation_mps2);
  for (const PairSample& sample : window) {
    if (!is_seen(sample)) continue;
    const double ago_s = now_s - sample.time_s;
    // A jerk j that is unknown to the fit displaces the robot by j t^3 / 6.
    const double strayed_m = kUnknownJerk_mps3 * ago_s * ago_s * ago_s / 6;
    fit.add(-ago_s, *sample.position_m[side],
            std::sqrt(square(strayed_m) + square(noise.robot_m) + square(kCollisionRounding_m)));
  }
  return fit.motion();
}

using PairMotion = PerSide<ConstantAcceleration>;

Vec2 between_m(const PairMotion& motion, double after_s) {
  return motion[Side::kEast].position_after(after_s) - motion[Side::kWest].position_after(after_s);
}

// Time until the cylinders touch; nullopt if they do not touch within `duration_s`.
std::optional<double> contact_after_s(const PairMotion& motion, double duration_s) {
  double former_m = between_m(motion, 0).norm();
  if (former_m <= kCylinders_m) return 0.0;
  const double step_s = duration_s / kContactSteps;
  for (int step = 1; step <= kContactSteps; ++step) {
    const double now_m = between_m(motion, step * step_s).norm();
    if (now_m <= kCylinders_m) {
      return (step - (kCylinders_m - now_m) / (former_m - now_m)) * step_s;
    }
    former_m = now_m;
  }
  return std::nullopt;
}

// The distance between the centres at `contact_s`, extrapolated from the frames after it by a
// least-squares line; nullopt with fewer than two frames.
std::optional<double> distance_afterwards_m(std::span<const PairSample> after, double contact_s) {
  double count = 0;
  double sum_s = 0;
  double sum_m = 0;
  double sum_s2 = 0;
  double sum_ms = 0;
  for (const PairSample& sample : after.first(std::min(after.size(), kFramesAfter))) {
    const auto& [west_m, east_m] = sample.position_m.values;
    if (!west_m || !east_m) continue;
    const double t_s = sample.time_s - contact_s;
    const double distance_m = (*east_m - *west_m).norm();
    count += 1;
    sum_s += t_s;
    sum_m += distance_m;
    sum_s2 += t_s * t_s;
    sum_ms += t_s * distance_m;
  }
  if (count < 2) return std::nullopt;
  return (sum_m * sum_s2 - sum_s * sum_ms) / (count * sum_s2 - sum_s * sum_s);
}

MeasuredCollision collision_at(const PairMotion& motion, double frame_s, double after_s) {
  MeasuredCollision collision;
  collision.time_s = frame_s + after_s;
  double variance = 0;
  for (const Side side : kSides) {
    collision.position_m[side] = motion[side].position_after(after_s);
    collision.velocity_mps[side] = motion[side].velocity_after(after_s);
    variance += square(motion[side].velocity_deviation_mps);
  }
  const Vec2 line = direction_of(between_m(motion, after_s), Vec2(1, 0));
  collision.closing_mps =
      (collision.velocity_mps[Side::kWest] - collision.velocity_mps[Side::kEast]).dot(line);
  collision.closing_deviation_mps = std::sqrt(variance);
  return collision;
}

}  // namespace

std::optional<MeasuredCollision> measure_collision(std::span<const PairSample> path, double from_s,
                                                   const tracking::VisionNoise& noise) {
  const double contact_m = kCylinders_m + kContactError_m + kContactDeviations * noise.robot_m;
  for (std::size_t last = 0; last + 2 < path.size(); ++last) {
    if (path[last + 1].time_s < from_s) continue;
    const auto west = motion_before(path, last, Side::kWest, noise);
    const auto east = motion_before(path, last, Side::kEast, noise);
    if (!west || !east) continue;
    const PairMotion motion{{*west, *east}};
    const double frame_s = path[last].time_s;
    const auto after_s = contact_after_s(motion, path[last + 1].time_s - frame_s);
    if (!after_s) continue;
    const auto distance_m = distance_afterwards_m(path.subspan(last + 1), frame_s + *after_s);
    if (!distance_m || !(*distance_m <= contact_m)) return std::nullopt;
    return collision_at(motion, frame_s, *after_s);
  }
  return std::nullopt;
}

}  // namespace autoref::referee
