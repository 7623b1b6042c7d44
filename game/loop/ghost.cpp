#include "game/loop/ghost.hpp"

#include <algorithm>
#include <cassert>

#include "soccer/geometry.hpp"

namespace autoref::game {
namespace {

// A touch is judged this long after it, when a tracker knows the ball's new velocity.
constexpr double kJudgeAfter_s = 0.15;
// A side that keeps touching the ball for longer has it for good.
constexpr double kLongestTouch_s = 1;
// The ball moves as recorded if it is this near, and if its velocity differs by no more than this
// or this share of its speed.
constexpr double kSamePosition_m = 0.1;
constexpr double kSameSpeed_mps = 0.5;
constexpr double kSameShare = 0.2;

// The state `share` of the way from one state to the other; the heading turns along the shorter
// arc.
sim::RobotState robot_between(const sim::RobotState& from, const sim::RobotState& to,
                              double share) {
  sim::RobotState robot = from;
  robot.position_m += share * (to.position_m - from.position_m);
  robot.heading = direction_of(from.heading + share * (to.heading - from.heading), from.heading);
  robot.velocity_mps += share * (to.velocity_mps - from.velocity_mps);
  robot.angular_velocity_radps += share * (to.angular_velocity_radps - from.angular_velocity_radps);
  return robot;
}

sim::BallState ball_between(const sim::BallState& from, const sim::BallState& to, double share) {
  sim::BallState ball = from;
  ball.position_m += share * (to.position_m - from.position_m);
  ball.velocity_mps += share * (to.velocity_mps - from.velocity_mps);
  ball.height_m += share * (to.height_m - from.height_m);
  ball.vertical_mps += share * (to.vertical_mps - from.vertical_mps);
  return ball;
}

const sim::RobotState* robot_numbered(int number, const sim::RobotStates& robots) {
  for (const sim::RobotState& robot : robots) {
    if (robot.number == number) return &robot;
  }
  return nullptr;
}

// The recording at a time between two frames. It shows the robots of the first frame, and the ball
// if both frames show it. At the first frame's time, it is that frame.
GhostFrame frame_between(const GhostFrame& from, const GhostFrame& to, double time_s) {
  GhostFrame frame = from;
  if (time_s <= from.time_s || to.time_s <= from.time_s) return frame;
  const double share = (time_s - from.time_s) / (to.time_s - from.time_s);
  frame.time_s = time_s;
  for (sim::RobotState& robot : frame.robots) {
    const sim::RobotState* const next = robot_numbered(robot.number, to.robots);
    if (next) robot = robot_between(robot, *next, share);
  }
  frame.ball.reset();
  if (from.ball && to.ball) frame.ball = ball_between(*from.ball, *to.ball, share);
  return frame;
}

bool moves_alike(const sim::BallState& recorded, const sim::BallState& now) {
  const double speed_mps = std::max(recorded.velocity_mps.norm(), now.velocity_mps.norm());
  return (recorded.position_m - now.position_m).norm() < kSamePosition_m &&
         (recorded.velocity_mps - now.velocity_mps).norm() <
             std::max(kSameSpeed_mps, kSameShare * speed_mps);
}

void bring_to_rest(sim::RobotState& robot) {
  robot.velocity_mps = {0, 0};
  robot.angular_velocity_radps = 0;
}

// Moves only the robots on the field; the recording may show numbers that the team lacks.
void put_robots(Side side, const sim::RobotStates& recorded, sim::World& world) {
  const sim::RobotStates on_field = world.state().robots[side];  // putting robots changes the state
  for (sim::RobotState robot : on_field) {
    if (const sim::RobotState* const shown = robot_numbered(robot.number, recorded)) {
      robot = *shown;
    } else {
      bring_to_rest(robot);
    }
    world.put_robot({side, robot.number}, robot);
  }
}

}  // namespace

Vec2 mirrored(const Vec2& vector) { return Vec2(0, 0) - vector; }

sim::RobotState mirrored(const sim::RobotState& robot) {
  return {robot.number, mirrored(robot.position_m), mirrored(robot.heading),
          mirrored(robot.velocity_mps), robot.angular_velocity_radps};
}

sim::BallState mirrored(const sim::BallState& ball) {
  return {mirrored(ball.position_m), mirrored(ball.velocity_mps), ball.height_m, ball.vertical_mps,
          ball.is_rolling};
}

Ghost mirrored(const Ghost& ghost) {
  Ghost other = ghost;
  other.side = opponent_of(ghost.side);
  for (GhostFrame& frame : other.frames) {
    for (sim::RobotState& robot : frame.robots) robot = mirrored(robot);
    if (frame.ball) frame.ball = mirrored(*frame.ball);
  }
  return other;
}

// Whether the other side has touched the ball since the last time.
bool GhostMover::touches_until(double time_s, const sim::World& world) {
  const std::size_t before = next_touch_;
  while (next_touch_ < ghost_.touches_s.size() && ghost_.touches_s[next_touch_] <= time_s)
    ++next_touch_;
  const auto touches = world.touches();
  return next_touch_ > before ||
         std::any_of(touches.begin(), touches.end(),
                     [this](const sim::Touch& touch) { return touch.robot.side != ghost_.side; });
}

void GhostMover::follow_touches(double time_s, const std::optional<sim::BallState>& recorded,
                                const sim::World& world) {
  if (touches_until(time_s, world)) {
    if (!touch_) touch_ = {time_s, time_s};
    touch_->last_s = time_s;
  }
  if (!touch_) return;
  if (time_s - touch_->first_s > kLongestTouch_s) is_free_ = true;
  if (time_s - touch_->last_s < kJudgeAfter_s || !recorded) return;
  is_free_ |= !moves_alike(*recorded, world.state().ball);
  touch_.reset();
}

void GhostMover::move(double time_s, sim::World& world) {
  const std::vector<GhostFrame>& frames = ghost_.frames;
  assert(!frames.empty());
  while (next_ < frames.size() && frames[next_].time_s <= time_s) ++next_;
  const GhostFrame& from = frames[next_ == 0 ? 0 : next_ - 1];
  const GhostFrame& to = frames[std::min(next_, frames.size() - 1)];
  GhostFrame now = frame_between(from, to, time_s);
  if (time_s > frames.back().time_s) {
    for (sim::RobotState& robot : now.robots) bring_to_rest(robot);
  }
  put_robots(ghost_.side, now.robots, world);
  if (time_s > frames.back().time_s) is_free_ = true;
  if (is_free_) return;
  follow_touches(time_s, now.ball, world);
  if (moves_ball() && now.ball) world.put_ball(*now.ball);
}

}  // namespace autoref::game
