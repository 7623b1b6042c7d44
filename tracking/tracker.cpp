#include "tracking/tracker.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace autoref::tracking {
namespace {

constexpr double kRobotLeastNoise_m = 0.05e-3;
constexpr double kLeastNoise_rad = 0.5e-3;
// Robots accelerate at 3 m/s2 or 40 rad/s2 for a few tenths of a second.
constexpr double kRobotProcessNoise_m2ps3 = 0.2;
constexpr double kProcessNoise_rad2ps3 = 6.0;
constexpr double kRobotAnySpeed_mps = 3.0;
constexpr double kFasterThanAnyRobot_mps = 15.0;  // at higher speeds the robot was relocated
constexpr double kAnyTurning_radps = 15.0;
// Chi-square with two degrees of freedom: a consistent filter exceeds it once in 3000 detections.
constexpr double kRobotInnovationGate = 16.0;

using Angle = MotionFilter<1>::Axis;

// The angle between two unit vectors. The angle is small from frame to frame, so a power series in
// its sine suffices.
double turned_angle(const Vec2& from, const Vec2& to) {
  const double sine = cross(from, to);
  if (from.dot(to) < 0.95) return angle_between(from, to);
  return sine * (1.0 + sine * sine / 6.0);
}

// `heading` rotated using the half-angle tangent formulas, with an error below 1e-5 rad; preserves
// its length.
Vec2 turned_by(const Vec2& heading, double angle_rad) {
  if (std::abs(angle_rad) > 0.25) return to_world(heading_of(angle_rad), heading);
  const double tangent = angle_rad / 2 + angle_rad * angle_rad * angle_rad / 24;
  const double scale = 1.0 / (1.0 + tangent * tangent);
  return to_world({(1.0 - tangent * tangent) * scale, 2.0 * tangent * scale}, heading);
}

}  // namespace

RobotTracker::RobotTracker(const VisionNoise& noise)
    : position_({std::max(noise.robot_m, kRobotLeastNoise_m), kRobotProcessNoise_m2ps3,
                 kRobotAnySpeed_mps}),
      turn_(
          {std::max(noise.robot_rad, kLeastNoise_rad), kProcessNoise_rad2ps3, kAnyTurning_radps}) {}

void RobotTracker::start(const RobotObservation& seen) {
  robot_ = {seen.number, seen.position_m, seen.heading, Vec2(0, 0), 0};
  position_.start(seen.position_m);
  turn_.start(Angle(0));
}

void RobotTracker::predict(double duration_s) {
  position_.predict(duration_s, Vec2(0, 0));
  turn_.predict(duration_s, Angle(0));
  publish();
}

void RobotTracker::correct(const RobotObservation& seen, double duration_s) {
  const Vec2 innovation_m = seen.position_m - robot_.position_m;
  if (innovation_m.norm() > kFasterThanAnyRobot_mps * duration_s) {
    start(seen);
    return;
  }
  if (position_.normalised_innovation_squared(innovation_m) > kRobotInnovationGate)
    position_.inflate_velocity_covariance(duration_s);
  position_.correct(innovation_m);
  const Angle innovation_rad(turned_angle(robot_.heading, seen.heading));
  if (turn_.normalised_innovation_squared(innovation_rad) > kRobotInnovationGate)
    turn_.inflate_velocity_covariance(duration_s);
  turn_.correct(innovation_rad);
  publish();
}

// This is an error-state filter: the angle is filtered relative to the last heading and reset to
// zero after each update, so it never wraps.
void RobotTracker::publish() {
  robot_.position_m = position_.position();
  robot_.velocity_mps = position_.velocity();
  robot_.heading = turned_by(robot_.heading, turn_.position().value());
  robot_.angular_velocity_radps = turn_.velocity().value();
  turn_.set_position(Angle(0));
}

Tracker::Tracker(const VisionNoise& noise) : noise_(noise), ball_(noise.ball_m) {
  for (auto& side : known_.values) side.fill({RobotTracker(noise), kNever_s});
}

const Tracks& Tracker::update(const Frame& frame) {
  const double duration_s = has_seen_frame_ ? frame.time_s - tracks_.time_s : 0;
  if (has_seen_frame_ && duration_s <= 0) return tracks_;
  has_seen_frame_ = true;
  tracks_.frame = frame.number;
  tracks_.time_s = frame.time_s;
  for (const Side side : kSides) {
    see_robots(frame.robots[side], known_[side], duration_s);
    tracks_.robots[side].clear();
    for (const Known& known : known_[side]) {
      if (!is_known(known)) continue;
      tracks_.robots[side].push_back(known.robot.robot());
      tracks_.robots[side].back().is_seen = known.seen_s == tracks_.time_s;
    }
  }
  tracks_.ball = ball_.update(frame.time_s, frame.ball, tracks_.robots);
  return tracks_;
}

bool Tracker::is_known(const Known& known) const {
  return tracks_.time_s - known.seen_s <= kForgetRobotAfter_s;
}

void Tracker::see_robots(const SeenRobots& seen, std::array<Known, kMaxRobots>& all,
                         double duration_s) {
  for (Known& known : all) {
    if (is_known(known)) known.robot.predict(duration_s);
  }
  for (const RobotObservation& robot : seen) {
    assert(robot.number >= 0 && robot.number < kMaxRobots);
    Known& known = all[static_cast<std::size_t>(robot.number)];
    if (is_known(known)) {
      known.robot.correct(robot, duration_s);
    } else {
      known.robot.start(robot);
    }
    known.seen_s = tracks_.time_s;
  }
}

}  // namespace autoref::tracking
