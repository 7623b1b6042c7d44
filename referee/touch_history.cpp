#include "referee/touch_history.hpp"

#include <algorithm>
#include <cmath>

#include "soccer/units.hpp"

namespace autoref::referee {
namespace {

// Touches by one robot that are no farther apart are one: three frames of a 60 Hz camera.
constexpr double kPause_s = 60_ms;
// The detector tells a touch anew when it knows better when it was: within this time it is the
// same.
constexpr double kRetold_s = 40_ms;
// A ball on the carpet for so long rolls; landings of a hopping ball are shorter.
constexpr double kRolls_s = 100_ms;
constexpr double kOnCarpet_m = 5_mm;

bool is_by(const BallTouch& touch, const LastTouch& told) {
  return touch.side == told.side && touch.robot == told.robot;
}

}  // namespace

void TouchHistory::update(const Moment& moment, double began_s) {
  const LastTouch& told = moment.last_touch;
  if (told.time_s > began_s && moment.ball) take_in(told, moment.ball->position_m);
  if (!kept_.empty() && moment.ball) follow_ball(kept_.back(), *moment.ball, moment.time_s());
}

void TouchHistory::take_in(const LastTouch& told, const Vec2& ball_m) {
  BallTouch* newest = kept_.empty() ? nullptr : &kept_.back();
  if (newest != nullptr && is_by(*newest, told) && told.time_s - newest->ended_s <= kPause_s) {
    newest->ended_s = std::max(newest->ended_s, told.time_s);
    return;
  }
  if (newest != nullptr && std::abs(told.time_s - newest->began_s) <= kRetold_s) {
    newest->side = told.side;
    newest->robot = told.robot;
    return;
  }
  if (kept_.size() == kKept) kept_.erase(kept_.begin());
  BallTouch touch;
  touch.side = told.side;
  touch.robot = told.robot;
  touch.began_s = touch.ended_s = told.time_s;
  touch.began_m = ball_m;
  kept_.push_back(touch);
  on_carpet_since_s_.reset();
  ++count_;
}

void TouchHistory::follow_ball(BallTouch& touch, const BallSight& ball, double now_s) {
  touch.highest_m = std::max(touch.highest_m, ball.height_m);
  touch.height_known = touch.height_known && ball.height_known;
  if (ball.height_m > kOnCarpet_m || !ball.height_known) {
    on_carpet_since_s_.reset();
  } else if (!on_carpet_since_s_) {
    on_carpet_since_s_ = now_s;
  }
  if (on_carpet_since_s_ && has_passed(*on_carpet_since_s_, kRolls_s, now_s)) touch.rolled = true;
}

}  // namespace autoref::referee
