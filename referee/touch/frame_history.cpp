#include "referee/touch/frame_history.hpp"

#include <algorithm>
#include <limits>

#include "referee/touch/touch_candidates.hpp"

namespace autoref::referee {
namespace {

constexpr double kNearBall_m = 1.0;

RobotObservation between(const RobotObservation& a, const RobotObservation& b, double share) {
  return {a.number, a.position_m + share * (b.position_m - a.position_m),
          direction_of(a.heading + share * (b.heading - a.heading), a.heading)};
}

PerSide<SeenRobots> between(const StoredFrame& a, const StoredFrame& b, double time_s) {
  PerSide<SeenRobots> robots = a.robots;
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  for (const Side side : kSides) {
    for (RobotObservation& robot : robots[side]) {
      const RobotObservation* later = find_robot(b.robots[side], robot.number);
      if (later != nullptr) robot = between(robot, *later, share);
    }
  }
  return robots;
}

}  // namespace

bool is_near_ball(const StoredFrame& frame, const RobotObservation& robot) {
  return !((robot.position_m - frame.ball.position_m).squaredNorm() > square(kNearBall_m));
}

FrameHistory::FrameHistory() { kept_[0].time_s = -std::numeric_limits<double>::infinity(); }

void FrameHistory::restart(const Frame& frame, const std::optional<Vec2>& ball_m) {
  newest_ = -1;
  detections_ = 0;
  jumps_ = false;
  StoredFrame& first = append(frame.time_s, frame.robots);
  first.ball = BallDetection{};
  if (!ball_m) return;
  first.ball.position_m = *ball_m;
  add_detection(first);
}

void FrameHistory::push(const Frame& frame, const std::optional<TrackedBall>& track) {
  if (!(frame.time_s > (*this)[newest_].time_s)) return;
  const BallDetection& former = (*this)[newest_].ball;
  StoredFrame& now = append(frame.time_s, frame.robots);
  now.ball = former;
  if (!frame.ball || !is_finite(frame.ball->position_m)) return;
  BallDetection& ball = now.ball;
  ball.position_m = frame.ball->position_m;
  ball.height_m = frame.ball->height_m.value_or(0.0);
  ball.height_deviation_m = track ? track->height_deviation_m : 0.0;
  ball.height_known = frame.ball->height_m || !track || track->is_height_known;
  ball.jumps = jumps_;
  const bool is_compared = detections_ > 0 && !jumps_;
  ball.duration_s = is_compared ? now.time_s - former.time_s : 0;
  ball.velocity_mps =
      is_compared ? Vec2((ball.position_m - former.position_m) / ball.duration_s) : Vec2(0, 0);
  jumps_ = false;
  add_detection(now);
}

StoredFrame& FrameHistory::append(double time_s, const PerSide<SeenRobots>& robots) {
  ++newest_;
  StoredFrame& frame = kept_[static_cast<std::size_t>(newest_) % kKept];
  frame.time_s = time_s;
  frame.has_ball = false;
  frame.robots = robots;
  return frame;
}

void FrameHistory::add_detection(StoredFrame& frame) {
  frame.has_ball = true;
  frame.ball.time_s = frame.time_s;
  detection_numbers_[static_cast<std::size_t>(detections_) % kDetections] = newest_;
  ++detections_;
}

std::int64_t FrameHistory::first_detection(double since_s) const {
  std::int64_t number = std::max<std::int64_t>(0, newest_ - kKept + 1);
  while (number <= newest_ && !((*this)[number].has_ball && (*this)[number].time_s >= since_s)) {
    ++number;
  }
  return number;
}

const BallDetection* FrameHistory::ball(std::size_t back) const {
  if (back >= kRecent || static_cast<std::int64_t>(back) >= detections_) return nullptr;
  const std::int64_t number = number_of_detection(static_cast<std::int64_t>(back));
  const bool is_kept = number > std::max<std::int64_t>(0, newest_ - kKept);
  return is_kept ? &(*this)[number].ball : nullptr;
}

const BallDetection* FrameHistory::ball_before(double time_s) const {
  const BallDetection* found = nullptr;
  for (std::size_t back = 0; ball(back) != nullptr; ++back) {
    found = ball(back);
    if (found->time_s <= time_s) break;
  }
  return found;
}

PerSide<SeenRobots> FrameHistory::robots_at(double time_s) const {
  if (newest_ == 0) return {};
  const std::int64_t oldest = std::max<std::int64_t>(1, newest_ - kRecent + 1);
  std::int64_t next = oldest;
  while (next <= newest_ && (*this)[next].time_s <= time_s) ++next;
  if (next == oldest) return (*this)[oldest].robots;
  if (next > newest_) return (*this)[newest_].robots;
  return between((*this)[next - 1], (*this)[next], time_s);
}

}  // namespace autoref::referee
