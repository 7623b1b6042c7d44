#include "referee/touch/recent_frames.hpp"

#include "referee/touch/touch_candidates.hpp"

namespace autoref::referee {
namespace {

RobotObservation between(const RobotObservation& a, const RobotObservation& b, double share) {
  return {a.number, a.position_m + share * (b.position_m - a.position_m),
          direction_of(a.heading + share * (b.heading - a.heading), a.heading)};
}

}  // namespace

void RecentFrames::add(const RefereeInput& input) {
  if (!stored_.empty() && !(input.time_s() > stored_.back().time_s)) return;
  if (stored_.size() == kKept) stored_.erase(stored_.begin());
  stored_.push_back({input.time_s(), input.frame.robots});
  if (!input.frame.ball || !input.ball) return;
  if (balls_.size() == kKept) balls_.erase(balls_.begin());
  const BallSight& ball = *input.ball;
  const double deviation_m = input.tracks.ball ? input.tracks.ball->height_deviation_m : 0.0;
  balls_.push_back(
      {input.time_s(), ball.position_m, ball.height_m, deviation_m, ball.height_known});
}

const RecentBall* RecentFrames::ball(std::size_t back) const {
  return back < balls_.size() ? &balls_[balls_.size() - 1 - back] : nullptr;
}

const RecentBall* RecentFrames::ball_before(double time_s) const {
  const RecentBall* found = balls_.empty() ? nullptr : &balls_.front();
  for (const RecentBall& ball : balls_) {
    if (ball.time_s <= time_s) found = &ball;
  }
  return found;
}

PerSide<SeenRobots> RecentFrames::robots_at(double time_s) const {
  if (stored_.empty()) return {};
  std::size_t next = 0;
  while (next < stored_.size() && stored_[next].time_s <= time_s) ++next;
  if (next == 0) return stored_.front().robots;
  PerSide<SeenRobots> robots = stored_[next - 1].robots;
  if (next == stored_.size()) return robots;
  const double began_s = stored_[next - 1].time_s;
  const double share = (time_s - began_s) / (stored_[next].time_s - began_s);
  for (const Side side : kSides) {
    for (RobotObservation& robot : robots[side]) {
      const RobotObservation* later = find_robot(stored_[next].robots[side], robot.number);
      if (later != nullptr) robot = between(robot, *later, share);
    }
  }
  return robots;
}

}  // namespace autoref::referee
