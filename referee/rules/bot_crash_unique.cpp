// Two opponents collide: substantial contact (Laws 12), crashing (2026).
//
// The measured value is their relative velocity just before, along the line of their centres. The
// faster robot is at fault. If the speeds differ by less than 0.3 m/s, nobody is at fault under the
// Laws of 2014 (play continues without a call), and both are under the 2026 rules.
//
// Robots collide when their 180 mm cylinders do. Between two flat fronts the hulls are then up to
// 30 mm apart, but robots closing at 1.5 m/s need four times that to brake.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "referee/rules/rule.hpp"
#include "referee/touch/constant_acceleration_fit.hpp"
#include "referee/touch/frame_history.hpp"
#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"

namespace autoref::referee {
namespace {

constexpr double kTouching_m = 2 * kRobotRadius_m;  // between the centres
// Robots count as separated after more than this distance for kApart_s: colliding robots bounce off
// each other a few times.
constexpr double kApart_m = kTouching_m + 20_mm;
constexpr double kApart_s = 200_ms;
// Speeds this close are equal up to rounding.
constexpr double kSame_mps = 1e-6;
// Standard deviations of a robot's acceleration and jerk; the jerk reaches full power in three
// frames.
constexpr double kAcceleration_mps2 = 4;
constexpr double kJerk_mps3 = 100;
constexpr double kBumped_mps2 = 10;           // more than any robot can brake by itself
constexpr int kCrashDetections = 4;           // detections needed for a fit
constexpr double kCrashRounding_m = 0.01e-3;  // position error of a noise-free camera

// The robot's track; null if vision did not see the robot in this frame.
const TrackedRobot* find_track(const TrackedRobots& robots, int number) {
  const auto found = std::find_if(
      robots.begin(), robots.end(),
      [number](const TrackedRobot& robot) { return robot.number == number && robot.is_seen; });
  return found == robots.end() ? nullptr : &*found;
}

// Time until two robots with constant relative velocity touch; nullopt if they do not within
// `duration_s`. `path_m` leads from one centre to the other.
std::optional<double> time_to_touch_s(const Vec2& path_m, const Vec2& velocity_mps,
                                      double duration_s) {
  // Smaller root of |path + velocity t| = kTouching_m. This form of the solution does not subtract
  // nearly equal numbers, and needs no division by a relative speed of zero.
  const double closing = -path_m.dot(velocity_mps);
  const double left_m2 = path_m.squaredNorm() - kTouching_m * kTouching_m;
  if (left_m2 <= 0) return 0.0;
  const double speed2 = velocity_mps.squaredNorm();
  const double root2 = closing * closing - speed2 * left_m2;
  if (closing <= 0 || root2 < 0) return std::nullopt;
  const double time_s = left_m2 / (closing + std::sqrt(root2));
  return time_s <= duration_s ? std::optional(time_s) : std::nullopt;
}

// A robot's motion at `now_s`: a constant-acceleration fit to its recent detections. Old detections
// get less weight, because robots may start to brake at any time. Falls back to the filtered track
// if detections are few, the robot has just been hit, or vision is noisy.
ConstantAcceleration motion_of(const FrameHistory& frames, Side side, const TrackedRobot& track,
                               double now_s, const VisionNoise& noise) {
  ConstantAccelerationFit fit(Vec2(0, 0), kAcceleration_mps2);
  int detections = 0;
  for (std::size_t back = 0; frames.ball(back) != nullptr; ++back) {
    const double time_s = frames.ball(back)->time_s;  // of the frame
    if (time_s > now_s) continue;
    const PerSide<SeenRobots> robots = frames.robots_at(time_s);
    const RobotObservation* seen = find_robot(robots[side], track.number);
    if (seen == nullptr) continue;
    const double ago_s = now_s - time_s;
    // The model's error: a jerk j that the fit does not know displaces the robot by j t^3 / 6.
    const double strayed_m = kJerk_mps3 * ago_s * ago_s * ago_s / 6;
    const double deviation_m = std::sqrt(strayed_m * strayed_m + noise.robot_m * noise.robot_m +
                                         kCrashRounding_m * kCrashRounding_m);
    fit.add(-ago_s, seen->position_m, deviation_m);
    ++detections;
  }
  ConstantAcceleration motion =
      detections < kCrashDetections ? ConstantAcceleration{} : fit.motion();
  const bool is_steady = motion.acceleration_mps2.norm() < kBumped_mps2;
  if (detections >= kCrashDetections && is_steady && noise.robot_m == 0) return motion;
  return {track.position_m, track.velocity_mps, Vec2(0, 0), 0};
}

// From 0 to pi; 0 if one velocity is zero.
double angle_between_rad(const Vec2& a_mps, const Vec2& b_mps) {
  const double across = a_mps.x() * b_mps.y() - a_mps.y() * b_mps.x();
  return atan2_exact(std::abs(across), a_mps.dot(b_mps));
}

// The collision of two robots `at_s` after the last frame, from their motions there.
Collision collision_of(const PerSide<ConstantAcceleration>& motions, int west, int east,
                       double at_s) {
  const Vec2 west_m = motions[Side::kWest].position_after(at_s);
  const Vec2 east_m = motions[Side::kEast].position_after(at_s);
  const Vec2 west_mps = motions[Side::kWest].velocity_after(at_s);
  const Vec2 east_mps = motions[Side::kEast].velocity_after(at_s);
  const Vec2 line = direction_of(east_m - west_m, Vec2(1, 0));
  const double lead_mps = west_mps.norm() - east_mps.norm();
  Collision collision;
  collision.faster = {Side::kWest, west};
  collision.slower = {Side::kEast, east};
  collision.faster_m = lead_mps < 0 ? east_m : west_m;
  if (lead_mps < 0) std::swap(collision.faster, collision.slower);
  collision.closing_mps = (west_mps - east_mps).dot(line);
  collision.lead_mps = std::abs(lead_mps);
  collision.angle_rad = angle_between_rad(west_mps, east_mps);
  collision.position_m = (west_m + east_m) / 2;
  return collision;
}

// The collision of two robots in this frame; nullopt if they do not collide, or if their collision
// is already known.
std::optional<Collision> intersection(CrashWatch& watch, const FrameHistory& frames,
                                      const RefereeInput& input, const TrackedRobot& west,
                                      const TrackedRobot& east) {
  double& met_s =
      watch.met_s[static_cast<std::size_t>(west.number)][static_cast<std::size_t>(east.number)];
  const double distance_m = (east.position_m - west.position_m).norm();
  if (!has_passed(met_s, kApart_s, input.time_s())) {
    if (distance_m <= kApart_m) met_s = input.time_s();
    return std::nullopt;
  }
  const TrackedRobot* west_before = find_track(watch.before[Side::kWest], west.number);
  const TrackedRobot* east_before = find_track(watch.before[Side::kEast], east.number);
  const bool is_new = west_before == nullptr || east_before == nullptr;
  const double duration_s = input.time_s() - watch.before_s;
  std::optional<double> at_s;
  if (!is_new) {
    at_s = time_to_touch_s(east_before->position_m - west_before->position_m,
                           east_before->velocity_mps - west_before->velocity_mps, duration_s);
  }
  if (!at_s && distance_m > kTouching_m) return std::nullopt;
  met_s = input.time_s();
  if (is_new) return std::nullopt;
  const VisionNoise& noise = input.configuration.noise;
  const PerSide<ConstantAcceleration> motions{
      {motion_of(frames, Side::kWest, *west_before, watch.before_s, noise),
       motion_of(frames, Side::kEast, *east_before, watch.before_s, noise)}};
  return collision_of(motions, west.number, east.number, at_s.value_or(duration_s));
}

bool is_drawn(const Collision& collision, const RuleBook& rules) {
  return collision.lead_mps < rules.crash_drawn_mps;
}

bool is_foul(const Collision& collision, const RuleBook& rules) {
  const bool is_called = rules.edition == Edition::kRules2026 || !is_drawn(collision, rules);
  return is_called && collision.closing_mps > rules.crash_mps;
}

void watch_robots(CrashWatch& watch, const FrameHistory& frames, const RefereeInput& input) {
  constexpr double kNear_m = 2 * kTouching_m;
  for (const TrackedRobot& west : input.tracks.robots[Side::kWest]) {
    for (const TrackedRobot& east : input.tracks.robots[Side::kEast]) {
      // The extrapolated position of an unseen robot is no evidence of a collision.
      if (!west.is_seen || !east.is_seen) continue;
      if ((east.position_m - west.position_m).squaredNorm() > kNear_m * kNear_m) continue;
      const std::optional<Collision> met = intersection(watch, frames, input, west, east);
      if (!met || !is_foul(*met, input.configuration.rules)) continue;
      if (watch.unreported.size() < watch.unreported.capacity()) watch.unreported.push_back(*met);
    }
  }
  watch.before = input.tracks.robots;
  watch.before_s = input.time_s();
}

Finding drawn_finding(const Collision& crash, const RuleBook& rules) {
  Finding finding = finding_of(Event::kBotCrashDrawn, RuleId::kBotCrashUnique, rules);
  finding.robots.push_back(crash.faster);
  finding.robots.push_back(crash.slower);
  finding.position_m = crash.position_m;
  return finding;
}

Finding crash_finding(const Collision& crash, const Configuration& configuration) {
  Finding finding = contact_foul_of(Event::kBotCrashUnique, RuleId::kBotCrashUnique, configuration,
                                    crash.faster, crash.faster_m, crash.position_m);
  finding.robots.push_back(crash.slower);
  return finding;
}

// Of two equally fast collisions, the one nearer to the centre comes first, so that neither side is
// favoured.
bool comes_after(const Collision& a, const Collision& b) {
  const double by_mps = b.closing_mps - a.closing_mps;
  if (std::abs(by_mps) > kSame_mps) return by_mps > 0;
  return a.position_m.squaredNorm() > b.position_m.squaredNorm();
}

// Takes the fastest unreported collision. If each side caused one equally fast, and only one can
// stop play, neither is reported.
std::optional<Collision> take_worst(CrashWatch& watch, const RuleBook& rules) {
  auto& unreported = watch.unreported;
  const auto worst = std::max_element(unreported.begin(), unreported.end(), comes_after);
  if (worst == unreported.end()) return std::nullopt;
  const Collision crash = *worst;
  const bool is_tied =
      std::any_of(unreported.begin(), unreported.end(), [&crash](const Collision& other) {
        return other.faster.side != crash.faster.side &&
               crash.closing_mps - other.closing_mps <= kSame_mps;
      });
  unreported.erase(worst);
  if (!is_tied || !rules.fouls_stop_play) return crash;
  unreported.clear();
  return std::nullopt;
}

// Collisions are reported one frame late, when they are certain.
std::optional<Finding> find_bot_crash_unique(RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  const std::optional<Collision> worst = take_worst(state.watch.bot_crash_unique, rules);
  watch_robots(state.watch.bot_crash_unique, input.frames, input);
  if (!worst) return std::nullopt;
  const Collision& crash = *worst;
  Finding finding = is_drawn(crash, rules) ? drawn_finding(crash, rules)
                                           : crash_finding(crash, input.configuration);
  finding.value = crash.closing_mps;
  finding.details.speed_difference_mps = crash.lead_mps;
  finding.details.crash_angle_rad = crash.angle_rad;
  finding.evidence = fmt::format(
      "{} and {} collided at {:.2f} m/s along the line of their centres; {} was faster by {:.2f} "
      "m/s.",
      text_of(crash.faster), text_of(crash.slower), crash.closing_mps, text_of(crash.faster),
      crash.lead_mps);
  return finding;
}

}  // namespace

constinit const Rule kBotCrashUniqueRule{{State::kRun}, find_bot_crash_unique};

}  // namespace autoref::referee
