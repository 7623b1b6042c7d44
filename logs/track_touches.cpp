#include "logs/track_touches.hpp"

#include "soccer/robot_shape.hpp"

namespace autoref::logs {
namespace {

constexpr double kSameTouch_s = 1e-6;
// Robots farther from the ball than this do not touch it.
constexpr double kFar_m = 1;
// A robot holds the ball if it is within kHeld_m of the hull for kHeldFor_s, moves relative to the
// robot no faster than kHeld_mps, and no opponent is within kAlone_m. The values were chosen in
// games of the camera presets `realistic` and `rc2026-b` other than those in
// docs/logs-and-pages.md.
constexpr double kHeld_m = 20_mm;
constexpr double kAlone_m = 30_mm;
constexpr double kHeldFor_s = 100_ms;
constexpr double kHeld_mps = 1.0_mps;
// A slower ball may just be at rest next to the robot.
constexpr double kMoves_mps = 0.4_mps;
// A ball that lies ready for a restart moves by less than this.
constexpr double kAtRest_m = 15_mm;

bool is_same(const referee::LastTouch& a, const referee::LastTouch& b) {
  return a.side == b.side && a.robot == b.robot && a.time_s == b.time_s;
}

const sim::RobotState* robot_in(const TrackedFrame& frame, RobotId id) {
  for (const sim::RobotState& robot : frame.world.robots[id.side])
    if (robot.number == id.number) return &robot;
  return nullptr;
}

struct NearRobot {
  const sim::RobotState* robot = nullptr;
  double gap_m = kFar_m;  // from its hull to the ball; at most kFar_m
};

PerSide<NearRobot> robots_at_ball(const TrackedFrame& frame) {
  PerSide<NearRobot> near;
  const Vec2& ball_m = frame.world.ball.position_m;
  for (const Side side : kSides) {
    for (const sim::RobotState& robot : frame.world.robots[side]) {
      const double gap_m =
          distance_to_hull(ball_m, robot.position_m, robot.heading) - kBallRadius_m;
      if (gap_m < near[side].gap_m) near[side] = {&robot, gap_m};
    }
  }
  return near;
}

// The side with the robot that is nearest to the ball.
Side side_at_ball(const PerSide<NearRobot>& near) {
  return near[Side::kWest].gap_m < near[Side::kEast].gap_m ? Side::kWest : Side::kEast;
}

// The robots that touched the ball, as far as is known.
std::vector<RobotId> touchers(const referee::LastTouch& touch, const TrackedFrame& frame) {
  if (touch.robot) return {*touch.robot};
  std::vector<RobotId> robots;
  const PerSide<NearRobot> near = robots_at_ball(frame);
  for (const Side side : kSides) {
    if (touch.side.value_or(side) == side && near[side].robot != nullptr)
      robots.push_back({side, near[side].robot->number});
  }
  return robots;
}

}  // namespace

void TrackTouches::update(const referee::AutoRef& referee, const TrackedFrame& frame) {
  const referee::LastTouch& touch = referee.last_touch();
  if (!is_same(touch, latest_)) {
    latest_ = touch;
    if (touch.time_s > 0) note(touch, frame.time_s);
  }
  if (is_noisy_) note_held(frame);
  note_restart(referee, frame);
}

void TrackTouches::add(RobotId robot, double time_s) {
  Report report;
  report.touch.side = robot.side;
  report.touch.robot = robot;
  report.touch.time_s = time_s;
  added_.push_back(report);
}

void TrackTouches::note_held(const TrackedFrame& frame) {
  const PerSide<NearRobot> near = robots_at_ball(frame);
  const Side side = side_at_ball(near);
  const sim::RobotState* robot = near[side].robot;
  const bool is_at_hull = near[side].gap_m < kHeld_m && near[opponent_of(side)].gap_m > kAlone_m;
  if (!is_at_hull || (frame.world.ball.velocity_mps - robot->velocity_mps).norm() > kHeld_mps) {
    holder_.reset();
    return;
  }
  const RobotId id{side, robot->number};
  if (holder_ != id) held_since_s_ = frame.time_s;
  holder_ = id;
  if (frame.time_s - held_since_s_ < kHeldFor_s) return;
  if (frame.world.ball.velocity_mps.norm() < kMoves_mps) return;
  add(id, frame.time_s);
}

void TrackTouches::note_restart(const referee::AutoRef& referee, const TrackedFrame& frame) {
  if (referee.is_ball_in_play()) {
    if (kicker_ && latest_.time_s == 0) add(*kicker_, at_rest_s_ + kSameTouch_s);
    kicker_.reset();
    return;
  }
  if (referee.state() != referee::State::kRun) return kicker_.reset();
  const Vec2& ball_m = frame.world.ball.position_m;
  if (!kicker_) rest_m_ = ball_m;
  if ((ball_m - rest_m_).norm() >= kAtRest_m) return;
  const PerSide<NearRobot> near = robots_at_ball(frame);
  const Side side = side_at_ball(near);
  if (near[side].robot == nullptr) return;
  kicker_ = RobotId{side, near[side].robot->number};
  at_rest_s_ = frame.time_s;
}

void TrackTouches::note(const referee::LastTouch& touch, double now_s) {
  // Later touches have been withdrawn or revised.
  while (!waiting_.empty() && waiting_.back().touch.time_s > touch.time_s + kSameTouch_s)
    waiting_.pop_back();
  // A touch that lies before the frame that reported another robot's touch replaces it.
  if (!waiting_.empty() && waiting_.back().touch.robot != touch.robot &&
      touch.time_s <= waiting_.back().reported_s)
    waiting_.pop_back();
  if (waiting_.empty() || !is_same(waiting_.back().touch, touch))
    waiting_.push_back({touch, now_s});
}

std::optional<double> TrackTouches::next_s() const {
  std::optional<double> next;
  for (const std::deque<Report>* reports : {&waiting_, &added_}) {
    if (reports->empty()) continue;
    const double time_s = reports->front().touch.time_s;
    if (!next || time_s < *next) next = time_s;
  }
  return next;
}

TrackTouches::Report TrackTouches::take_oldest() {
  const bool is_added = !added_.empty() && added_.front().touch.time_s == next_s();
  std::deque<Report>& reports = is_added ? added_ : waiting_;
  const Report oldest = reports.front();
  reports.pop_front();
  return oldest;
}

std::vector<sim::Touch> TrackTouches::take(const std::optional<TrackedFrame>& before,
                                           const std::deque<TrackedFrame>& frames) {
  std::vector<sim::Touch> touches;
  for (int substep = 0; next_s().value_or(frames.front().time_s + 1) <= frames.front().time_s;
       ++substep) {
    for (sim::Touch touch : touches_for(take_oldest(), before, frames)) {
      touch.substep = substep;
      touches.push_back(touch);
    }
  }
  return touches;
}

// Call it when the report has been removed from those that wait.
std::vector<sim::Touch> TrackTouches::touches_for(const Report& report,
                                                  const std::optional<TrackedFrame>& before,
                                                  const std::deque<TrackedFrame>& frames) const {
  const TrackedFrame& now = frames.front();
  const double until_s = next_s().value_or(now.time_s + kLookAhead_s);
  const double touched_s = report.touch.time_s;
  const Vec2 from_m = before ? before->world.ball.position_m +
                                   before->world.ball.velocity_mps * (touched_s - before->time_s)
                             : now.world.ball.position_m;
  const BallAfterTouch after = ball_after_touch(frames, from_m, touched_s, until_s);
  const Vec2 before_mps = before ? before->world.ball.velocity_mps : Vec2(0, 0);
  const std::vector<RobotId> robots = touchers(report.touch, now);
  std::vector<sim::Touch> touches;
  for (const RobotId id : robots) {
    const sim::RobotState* robot = robot_in(now, id);
    if (robot == nullptr) continue;
    sim::Touch touch;
    touch.robot = id;
    touch.ball_m = from_m;
    touch.is_kick = robots.size() == 1 && is_kick(*robot, from_m, before_mps, after.velocity_mps);
    touch.ball_mps = after.velocity_mps;
    touch.vertical_mps = touch.is_kick ? after.vertical_mps : 0;
    touches.push_back(touch);
  }
  return touches;
}

}  // namespace autoref::logs
