#include "referee/touch/touch_history.hpp"

#include <algorithm>
#include <cmath>

#include "referee/touch/touch_candidates.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// Ball and hull are apart if the gap exceeds this distance plus three standard deviations.
constexpr double kHistoryApart_m = 20_mm;
constexpr double kSureDeviations = 3;
// Touches by unknown robots count as one touch unless they are at least three frames apart in time.
constexpr double kPause_s = 60_ms;
// A touch may be revised in the next two frames of a 60 Hz camera.
constexpr double kSettles_s = 30_ms;
// A ball that has been on the carpet for this long is rolling; a hopping ball leaves the carpet
// sooner.
constexpr double kRolls_s = 100_ms;
constexpr double kOnCarpet_m = 5_mm;
constexpr double kNoTime_s = 1e-6;  // less than the frame period of any camera

bool is_by(const BallTouch& touch, const LastTouch& reported) {
  return touch.side == reported.side && touch.robot == reported.robot;
}

bool is_another(const BallTouch& touch, double time_s) {
  if (touch.robot) return touch.apart_s && time_s > *touch.apart_s;
  return time_s - touch.ended_s > kPause_s;
}

bool is_apart(const BallTouch& touch, const RefereeInput& input) {
  const RobotObservation* robot =
      find_robot(input.frame.robots[touch.robot->side], touch.robot->number);
  if (robot == nullptr) return true;
  const tracking::VisionNoise& noise = input.configuration.noise;
  const double noise_m = kSureDeviations * std::hypot(noise.ball_m, noise.robot_m);
  return gap_to_robot_m(*robot, input.ball->position_m) > kHistoryApart_m + noise_m;
}

void locate_end(BallTouch& touch, const FrameHistory& frames) {
  const BallDetection* ball = frames.ball_before(touch.ended_s);
  if (ball != nullptr) touch.ended_m = ball->position_m;
  touch.toucher.reset();
  if (!touch.robot) return;
  const PerSide<SeenRobots> robots = frames.robots_at(touch.ended_s);
  const RobotObservation* robot = find_robot(robots[touch.robot->side], touch.robot->number);
  if (robot == nullptr) return;
  touch.toucher = *robot;
  if (ball == nullptr) return;
  // A touch is reported up to a frame late, when the ball may already have left the robot.
  const Vec2& before_m = frames.ball_before(ball->time_s - kNoTime_s)->position_m;
  if (gap_to_robot_m(*robot, before_m) < gap_to_robot_m(*robot, touch.ended_m)) {
    touch.ended_m = before_m;
  }
}

}  // namespace

void TouchHistory::update(const RefereeInput& input, double began_s) {
  const LastTouch& reported = input.last_touch;
  if (reported.time_s > began_s) {
    take_in(input);
  } else if (!kept_.empty()) {
    withdraw();  // the detector has withdrawn the first touch
  }
  if (!kept_.empty() && input.ball) follow_ball(kept_.back(), input);
}

bool TouchHistory::is_one_robots() const {
  if (count_ > kept()) return false;
  return std::all_of(kept_.begin(), kept_.end(), [this](const BallTouch& touch) {
    return count_ == 1 || (touch.robot && touch.robot == kept_.front().robot);
  });
}

void TouchHistory::take_in(const RefereeInput& input) {
  const LastTouch& reported = input.last_touch;
  if (kept_.empty()) {
    begin(input);
    return;
  }
  BallTouch& newest = kept_.back();
  if (is_by(newest, reported)) {
    if (reported.time_s == newest.ended_s) return;
    is_another(newest, reported.time_s) ? begin(input) : extend(newest, input);
  } else {
    // If the reported time is before the frame that first reported the newest touch, the report
    // revises that touch.
    reported.time_s > newest.reported_s ? begin(input) : correct(input);
  }
}

void TouchHistory::begin(const RefereeInput& input) {
  const LastTouch& reported = input.last_touch;
  if (kept_.size() == kKept) kept_.erase(kept_.begin());
  BallTouch touch;
  touch.side = reported.side;
  touch.robot = reported.robot;
  touch.began_s = touch.ended_s = reported.time_s;
  touch.reported_s = input.time_s();
  locate_end(touch, input.frames);
  touch.began_m = touch.ended_m;
  kept_.push_back(touch);
  on_carpet_since_s_.reset();
  ++count_;
}

void TouchHistory::extend(BallTouch& touch, const RefereeInput& input) {
  const LastTouch& reported = input.last_touch;
  const bool is_moved = reported.time_s <= touch.reported_s && touch.began_s == touch.ended_s;
  touch.ended_s = is_moved ? reported.time_s : std::max(touch.ended_s, reported.time_s);
  locate_end(touch, input.frames);
  if (!is_moved) return;
  touch.began_s = touch.ended_s;
  touch.began_m = touch.ended_m;
}

void TouchHistory::correct(const RefereeInput& input) {
  const LastTouch& reported = input.last_touch;
  if (kept_.size() > 1 && is_by(kept_[kept_.size() - 2], reported)) {
    withdraw();
    take_in(input);
    return;
  }
  BallTouch& touch = kept_.back();
  touch.side = reported.side;
  touch.robot = reported.robot;
  touch.began_s = touch.ended_s = reported.time_s;
  touch.apart_s.reset();
  locate_end(touch, input.frames);
  touch.began_m = touch.ended_m;
}

void TouchHistory::withdraw() {
  const BallTouch taken_back = kept_.back();
  kept_.pop_back();
  --count_;
  if (kept_.empty()) return;
  BallTouch& newest = kept_.back();
  newest.highest_m = std::max(newest.highest_m, taken_back.highest_m);
  newest.height_known = newest.height_known && taken_back.height_known;
}

void TouchHistory::follow_ball(BallTouch& touch, const RefereeInput& input) {
  const BallSight& ball = *input.ball;
  if (touch.robot && !touch.apart_s && is_apart(touch, input)) touch.apart_s = input.time_s();
  touch.highest_m = std::max(touch.highest_m, ball.height_m);
  touch.height_known = touch.height_known && ball.height_known;
  if (ball.height_m > kOnCarpet_m || !ball.height_known) {
    on_carpet_since_s_.reset();
  } else if (!on_carpet_since_s_) {
    on_carpet_since_s_ = input.time_s();
  }
  touch.rolled = on_carpet_since_s_ && has_passed(*on_carpet_since_s_, kRolls_s, input.time_s());
}

bool is_settled(const BallTouch& touch, double now_s) {
  return has_passed(touch.reported_s, kSettles_s, now_s);
}

}  // namespace autoref::referee
