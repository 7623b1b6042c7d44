#include "logs/tracked_frame.hpp"

#include <algorithm>

#include "game/play_counts/play_counts.hpp"
#include "sim/sim_configuration.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::logs {
namespace {

// Detections in this time after a touch give the ball's velocity, unless another touch follows.
constexpr double kFit_s = 100_ms;
// A ball that has been this high since the touch was chipped.
constexpr double kChip_m = 30_mm;
// A kick leaves within this angle of the robot's heading: cos 40 deg.
constexpr double kKickCosine = 0.77;
// How much faster than a bounce off the hull the ball of a kick leaves.
constexpr double kFasterThanBounce_mps = 0.5;

// The ball's detections in part of the frames, as a line.
struct BallPath {
  int detections = 0;
  double middle_s = 0;
  Vec2 velocity_mps{0, 0};
};

BallPath path_in(const std::deque<TrackedFrame>& frames, double from_s, double to_s) {
  BallPath path;
  Vec2 mean_m{0, 0};
  const auto for_each = [&](const auto& action) {
    for (const TrackedFrame& frame : frames) {
      if (frame.time_s > to_s) break;
      if (frame.ball_m && frame.time_s >= from_s) action(frame);
    }
  };
  for_each([&](const TrackedFrame& frame) {
    ++path.detections;
    path.middle_s += frame.time_s;
    mean_m += *frame.ball_m;
  });
  if (path.detections < 2) return path;
  path.middle_s /= path.detections;
  mean_m /= path.detections;
  double squares_s2 = 0;
  for_each([&](const TrackedFrame& frame) {
    const double off_s = frame.time_s - path.middle_s;
    path.velocity_mps += off_s * (*frame.ball_m - mean_m);
    squares_s2 += off_s * off_s;
  });
  path.velocity_mps /= squares_s2;
  return path;
}

// The velocity of a chipped ball, which flies without friction; nullopt if the ball was not chipped
// between the two times.
std::optional<BallAfterTouch> flight(const std::deque<TrackedFrame>& frames, const Vec2& from_m,
                                     double touched_s, double to_s) {
  for (const TrackedFrame& frame : frames) {
    const double flown_s = frame.time_s - touched_s;
    const sim::BallState& ball = frame.world.ball;
    if (frame.time_s > to_s) break;
    if (flown_s <= 0 || ball.height_m < kChip_m) continue;
    return BallAfterTouch{(ball.position_m - from_m) / flown_s,
                          ball.height_m / flown_s + kGravity_mps2 * flown_s / 2};
  }
  return std::nullopt;
}

}  // namespace

BallAfterTouch ball_after_touch(const std::deque<TrackedFrame>& frames, const Vec2& from_m,
                                double touched_s, double next_s) {
  if (const auto flown =
          flight(frames, from_m, touched_s, std::min(next_s, touched_s + kLookAhead_s)))
    return *flown;
  const BallPath path = path_in(frames, touched_s, std::min(next_s, touched_s + kFit_s));
  if (path.detections < 2) return {frames.front().world.ball.velocity_mps};
  // The carpet slows the ball until the middle of the path.
  const double speed_mps = path.velocity_mps.norm();
  if (speed_mps < game::kAway_mps) return {path.velocity_mps};
  const double slowed_mps = sim::BallParameters{}.slide_mps2 * (path.middle_s - touched_s);
  return {path.velocity_mps * (1 + slowed_mps / speed_mps)};
}

bool is_kick(const sim::RobotState& robot, const Vec2& ball_m, const Vec2& before_mps,
             const Vec2& after_mps) {
  const Vec2 away_mps = after_mps - robot.velocity_mps;
  const double speed_mps = away_mps.norm();
  if (speed_mps < game::kAway_mps) return false;
  const double forward_mps = away_mps.dot(robot.heading);
  if (forward_mps < kKickCosine * speed_mps) return false;
  if ((ball_m - robot.position_m).dot(robot.heading) < kFrontDistance_m / 2) return false;
  const double arriving_mps = std::max(0.0, (robot.velocity_mps - before_mps).dot(robot.heading));
  const double bounce_mps = sim::ContactParameters{}.body_restitution * arriving_mps;
  return forward_mps > bounce_mps + kFasterThanBounce_mps;
}

std::optional<TrackedFrame> tracked_frame(const referee::AutoRef& referee) {
  const Tracks& tracks = referee.tracks();
  const Frame& frame = referee.frame();
  if (!tracks.ball) return std::nullopt;
  TrackedFrame tracked;
  tracked.time_s = frame.time_s;
  if (frame.ball) tracked.ball_m = frame.ball->position_m;
  for (const Side side : kSides) {
    for (const TrackedRobot& robot : tracks.robots[side])
      tracked.world.robots[side].push_back({robot.number, robot.position_m, robot.heading,
                                            robot.velocity_mps, robot.angular_velocity_radps});
  }
  tracked.world.ball.position_m = tracks.ball->position_m;
  tracked.world.ball.velocity_mps = tracks.ball->velocity_mps;
  tracked.world.ball.height_m = tracks.ball->height_m;
  return tracked;
}

}  // namespace autoref::logs
