#include "referee/touch/ball_jump_filter.hpp"

namespace autoref::referee {
namespace {

// No ball is faster.
constexpr double kFastest_mps = 15;
constexpr double kSlack_m = 0.2;
// Two cameras project a high ball to points so far apart.
constexpr double kBetweenCameras_m = 2;

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

// Whether the ball is where the pending ones lead rather than where the accepted ones do.
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

}  // namespace autoref::referee
