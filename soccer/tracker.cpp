#include "soccer/tracker.hpp"

#include <cassert>

namespace autoref {
namespace {

// The angle between two unit vectors; from frame to frame it is small, and the sine's series does.
double turned_angle(const Vec2& from, const Vec2& to) {
  const double sine = cross(from, to);
  if (from.dot(to) < 0.95) return angle_between(from, to);
  return sine * (1.0 + sine * sine / 6.0);
}

}  // namespace

void Tracker::see(Memory& memory, const RobotObservation& seen, double time_s) const {
  TrackedRobot& robot = memory.robot;
  const double gap_s = time_s - memory.seen_s;
  const bool is_new = memory.seen_s < 0 || gap_s > kForgetRobotAfter_s;
  if (is_new) {
    robot = {seen.number, seen.position_m, seen.heading, Vec2(0, 0), 0};
  } else if (gap_s > 0) {
    robot.velocity_mps = (seen.position_m - robot.position_m) / gap_s;
    robot.angular_velocity_radps = turned_angle(robot.heading, seen.heading) / gap_s;
    robot.position_m = seen.position_m;
    robot.heading = seen.heading;
  }
  memory.seen_s = time_s;
}

void Tracker::see_ball(const BallObservation& seen, double time_s) {
  const double height_m = seen.height_m.value_or(0.0);
  const double gap_s = time_s - ball_seen_s_;
  if (!tracks_.ball) {
    tracks_.ball = TrackedBall{seen.position_m, Vec2(0, 0), height_m};
  } else if (gap_s > 0) {
    tracks_.ball->velocity_mps = (seen.position_m - tracks_.ball->position_m) / gap_s;
    tracks_.ball->position_m = seen.position_m;
    tracks_.ball->height_m = height_m;
  }
  ball_seen_s_ = time_s;
}

const Tracks& Tracker::update(const Frame& frame) {
  tracks_.time_s = frame.time_s;
  for (Side side : kSides) {
    auto& memory = memory_[side];
    for (const RobotObservation& seen : frame.robots[side]) {
      assert(seen.number >= 0 && seen.number < kMaxRobots);
      see(memory[static_cast<std::size_t>(seen.number)], seen, frame.time_s);
    }
    tracks_.robots[side].clear();
    for (const Memory& known : memory) {
      if (known.seen_s >= 0 && frame.time_s - known.seen_s <= kForgetRobotAfter_s) {
        tracks_.robots[side].push_back(known.robot);
      }
    }
  }
  if (frame.ball) see_ball(*frame.ball, frame.time_s);
  return tracks_;
}

TrackedRobot mirrored(const TrackedRobot& robot) {
  return {robot.number, -robot.position_m, -robot.heading, -robot.velocity_mps,
          robot.angular_velocity_radps};
}

TrackedBall mirrored(const TrackedBall& ball) {
  return {-ball.position_m, -ball.velocity_mps, ball.height_m};
}

}  // namespace autoref
