#include "referee/touch/sight.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace autoref::referee {
namespace {

// No ball in the league is faster than this.
constexpr double kFastest_mps = 15;
constexpr double kSlack_m = 0.2;
// Two cameras can project a high ball to points that are this far apart.
constexpr double kBetweenCameras_m = 2;

// Nothing is inferred across a longer gap in vision.
constexpr double kLongestGap_s = 1;

}  // namespace

BallJumpFilter::Detection BallJumpFilter::detection_in(const Frame& frame) {
  const BallObservation& ball = *frame.ball;
  return {ball.position_m, ball.seen_from.position_m, frame.time_s};
}

bool BallJumpFilter::is_possible(const Detection& from, const Detection& to) {
  const double slack_m = from.camera_m == to.camera_m ? kSlack_m : kBetweenCameras_m;
  return (to.position_m - from.position_m).norm() <=
         slack_m + kFastest_mps * (to.time_s - from.time_s);
}

void BallJumpFilter::filter(Frame& frame) {
  jumped_.clear();
  if (!frame.ball) return;
  const Detection now = detection_in(frame);
  const bool follows = follows_pending(now);
  if (!follows && (!last_ || is_possible(*last_, now))) {
    last_ = now;
    pending_.clear();
    return;
  }
  if (!follows) pending_.clear();
  pending_.push_back(frame);
  if (pending_.size() < kConfirmed) {
    frame.ball.reset();
    return;
  }
  last_ = now;
  std::swap(jumped_, pending_);
  pending_.clear();
}

// Whether the ball is where the pending detections predict it, rather than where the accepted
// detections do.
bool BallJumpFilter::follows_pending(const Detection& now) const {
  if (pending_.empty()) return false;
  const Detection before = detection_in(pending_.back());
  return is_possible(before, now) && (now.position_m - before.position_m).squaredNorm() <
                                         (now.position_m - last_->position_m).squaredNorm();
}

void BallJumpFilter::forget() {
  last_.reset();
  pending_.clear();
  jumped_.clear();
}

Sight::Sight(const Configuration& configuration, bool ball_may_jump)
    : ball_may_jump_(ball_may_jump),
      online_touch_(history_, configuration.field, configuration.touch, configuration.noise),
      retrospective_touch_(history_, configuration.field, TouchHypothesisParameters{},
                           configuration.noise) {}

bool Sight::add(const Frame& frame, bool is_play) {
  const bool is_gap = has_begun_ && frame.time_s - frame_.time_s > kLongestGap_s;
  frame_ = is_finite(frame) ? frame : finite_part(frame);
  is_complete_ = false;
  if (is_gap) forget(is_play);
  if (!ball_may_jump_) return is_gap;
  if (!is_play) ball_jump_.forget();
  ball_jump_.filter(frame_);
  return is_gap;
}

// Begins afresh, but keeps what is needed to infer the last touch from the ball's later motion.
void Sight::forget(bool is_play) {
  if (is_play) before_gap_ = online_touch_.before_gap();
  ball_.reset();
  ball_jump_.forget();
  was_lifted_ = false;
  joins_ = is_play;
}

void Sight::complete(const Tracks& tracks) {
  assert(!is_complete_);
  is_complete_ = true;
  tracks_ = tracks;
  has_begun_ = true;
  add_unseen_robots();
  lift_ball();
  see_ball();
}

// Robots missing from the frame are added at the tracker's estimate. Both lists are sorted by
// number.
void Sight::add_unseen_robots() {
  for (const Side side : kSides) {
    SeenRobots& robots = frame_.robots[side];
    if (robots.size() == tracks_.robots[side].size()) continue;
    for (const TrackedRobot& known : tracks_.robots[side]) {
      if (find_robot(robots, known.number) != nullptr) continue;
      const auto next = std::find_if(
          robots.begin(), robots.end(),
          [&known](const RobotObservation& robot) { return robot.number > known.number; });
      robots.insert(next, {known.number, known.position_m, known.heading});
    }
  }
}

// Without a reported height, a flying ball is not where the camera projects it, so the tracker's
// position is used.
void Sight::lift_ball() {
  // If the frame is not newer than the last one, the tracker has no ball.
  if (!frame_.ball || frame_.ball->height_m || !tracks_.ball) return;
  const bool flies = tracks_.ball->height_m > 0;
  if (flies) {
    frame_.ball->position_m = tracks_.ball->position_m;
    frame_.ball->height_m = tracks_.ball->height_m;
  }
  // The positions come from another source from here on, so a velocity computed across the change
  // would be wrong.
  if (flies != was_lifted_) history_.lose_sight();
  was_lifted_ = flies;
}

// A frame without a ball keeps the last known ball.
void Sight::see_ball() {
  if (!frame_.ball) return;
  const Vec2& now_m = frame_.ball->position_m;
  const double height_m = frame_.ball->height_m.value_or(0.0);
  ball_ = BallSight{now_m, ball_ ? ball_->position_m : now_m, height_m,
                    frame_.ball->height_m || !tracks_.ball || tracks_.ball->is_height_known};
}

void Sight::begin_play(const Frame& frame, const std::optional<Vec2>& ball_from_m) {
  history_.restart(frame, ball_from_m);
  online_touch_.restart();
}

const Frame* Sight::frame_to_join() const {
  if (joins_) return &frame_;
  return ball_jump_.jumped().empty() ? nullptr : &ball_jump_.jumped().front();
}

void Sight::join_play() {
  if (std::exchange(joins_, false)) {
    begin_play(frame_, std::nullopt);
    if (before_gap_) online_touch_.resume(*std::exchange(before_gap_, std::nullopt));
    return;
  }
  // The ball counts as being at rest where it appeared, so that a robot that kicks it away
  // immediately is seen to touch it.
  const BallJumpFilter::Frames& jumped = ball_jump_.jumped();
  begin_play(jumped.front(), jumped.front().ball->position_m);
  for (const Frame& frame : jumped) {
    history_.push(frame);
    online_touch_.update();
  }
}

void Sight::follow_ball() {
  history_.push(frame_, tracks_.ball);
  online_touch_.update();
}

}  // namespace autoref::referee
