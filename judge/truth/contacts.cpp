// Fouls of a robot in contact with the ball: double touch, dribbling, holding.
#include <algorithm>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kAgainMargin_m = 10_mm;      // noise of two detected positions of the ball
constexpr double kDribblingMargin_m = 50_mm;  // uncertainty of a contact's starting point
constexpr double kHoldingMargin_s = 0.2;
// If the ball would have gone too far within this time after the end of play, the call was early.
constexpr double kContactLead_s = 0.05;

// Double touch: the kicker of a restart touches the ball, again or still, after the ball has moved
// more than `double_touch_m` from its position and has been in play for `double_touch_s`, and
// before another robot touches it (Laws 2014, law 9, decision 1; 2026, Double Touch). In 2026, this
// does not apply to penalty kicks.
class DoubleTouch final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const TruePlay& play = frame.play;
    if (play.count != count_) begin(play);
    const bool is_2026 = frame.rules.edition == Edition::kRules2026;
    if (is_over_ || !play.is_on || !play.taker || (is_2026 && play.is_penalty())) return;
    const bool is_out = inside_m(frame.field, frame.now.ball.position_m) < 0;
    for (const sim::Touch& touch : frame.touches) {
      if (is_out && inside_m(frame.field, touch.ball_m) < 0) break;
      touched(frame, touch, all);
    }
    farthest_m_ = std::max(farthest_m_, (frame.now.ball.position_m - play.ball_from_m).norm());
  }

 private:
  void begin(const TruePlay& play) {
    count_ = play.count;
    kicker_.reset();
    farthest_m_ = 0;
    is_over_ = is_near_reported_ = false;
    reported_at_.reset();
  }

  void touched(const TrueFrame& frame, const sim::Touch& touch, TrueEvents& all) {
    if (!kicker_) kicker_ = touch.robot;
    is_over_ = is_over_ || touch.robot != *kicker_ || touch.robot.side != frame.play.taker;
    if (is_over_) return;
    farthest_m_ = std::max(farthest_m_, (touch.ball_m - frame.play.ball_from_m).norm());
    if (!is_kick_time_over(frame)) return;
    const double excess_m = farthest_m_ - frame.rules.double_touch_m;
    if (reported_at_) {
      if (excess_m > kAgainMargin_m) all[*reported_at_].is_borderline = false;
      return;
    }
    if (excess_m <= 0 && is_near_reported_) return;
    is_near_reported_ = excess_m > -kAgainMargin_m;
    if (excess_m > 0) reported_at_ = all.size();
    add_measured(
        all,
        {"attacker_double_touched_ball", frame.time_s, touch.robot.side, touch.robot, touch.ball_m},
        excess_m, kAgainMargin_m);
  }

  // Whether the ball has been in play for `double_touch_s`.
  static bool is_kick_time_over(const TrueFrame& frame) {
    const double time_s = frame.rules.double_touch_s;
    return time_s == 0 || (frame.play.in_play && has_passed(frame, frame.play.entered_s, time_s));
  }

  int count_ = -1;
  std::optional<RobotId> kicker_;
  double farthest_m_ = 0;  // largest distance of the ball from its position at the restart
  bool is_over_ = false;   // another robot has touched the ball
  bool is_near_reported_ = false;
  std::optional<std::size_t> reported_at_;  // index of the reported event
};

class Dribbling final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const bool is_out = inside_m(frame.field, frame.now.ball.position_m) < 0;
    if (!frame.play.is_on || is_out) return;
    for (const Contact& contact : frame.ball.contacts()) {
      const double path_m = (frame.now.ball.position_m - contact.ball_from_m).norm();
      const double excess_m = path_m - frame.rules.dribbling_m;
      if (excess_m <= -kDribblingMargin_m) continue;
      TrueEvent dribble{"bot_dribbled_ball_too_far", frame.time_s, contact.robot.side,
                        contact.robot, frame.now.ball.position_m};
      if (excess_m <= 0 && is_prevented(frame, contact, excess_m)) {
        dribble.standing = Standing::kPrevented;
        all.push_back(dribble);
      }
      int& reported = excess_m > 0 ? reported_ : nearly_reported_;
      if (reported == contact.count) {
        // An event is borderline only if it ends near the limit.
        if (excess_m > kDribblingMargin_m) all[reported_at_].is_borderline = false;
        continue;
      }
      reported = contact.count;
      if (excess_m > 0) reported_at_ = all.size();
      add_measured(all, dribble, excess_m, kDribblingMargin_m);
    }
  }

 private:
  // Whether the referee has just stopped play while the ball was about to go too far.
  static bool is_prevented(const TrueFrame& frame, const Contact& contact, double excess_m) {
    const Vec2 path_m = frame.now.ball.position_m - contact.ball_from_m;
    const double away_mps = frame.now.ball.velocity_mps.dot(direction_of(path_m, Vec2(1.0, 0.0)));
    return frame.play.ends_now && excess_m + kContactLead_s * away_mps > 0;
  }

  int reported_ = 0;
  std::size_t reported_at_ = 0;  // index of the reported event
  int nearly_reported_ = 0;
};

class KeeperHolding final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (!frame.play.is_on || !frame.play.in_play) {
      since_s_ = {{frame.time_s, frame.time_s}};
      return;
    }
    for (const Side side : kSides) watch(frame, side, all);
  }

 private:
  void watch(const TrueFrame& frame, Side side, TrueEvents& all) {
    if (!is_keepers_ball(frame, side)) {
      since_s_[side] = frame.time_s;
      is_reported_[side] = false;
      return;
    }
    if (is_reported_[side]) return;
    const double excess_s = frame.time_s - since_s_[side] - frame.rules.keeper_holding_s;
    const bool is_prevented = frame.play.ends_now && excess_s > -kHoldingMargin_s;
    if (excess_s <= 0 && !is_prevented) return;
    is_reported_[side] = true;
    TrueEvent held{"keeper_held_ball", frame.time_s, side, RobotId{side, frame.keepers[side]},
                   frame.now.ball.position_m};
    if (excess_s <= 0) held.standing = Standing::kPrevented;
    all.push_back(held);
  }

  PerSide<double> since_s_;
  PerSide<bool> is_reported_;
};

}  // namespace

std::unique_ptr<GroundTruthRule> attacker_double_touched_ball() {
  return std::make_unique<DoubleTouch>();
}
std::unique_ptr<GroundTruthRule> bot_dribbled_ball_too_far() {
  return std::make_unique<Dribbling>();
}
std::unique_ptr<GroundTruthRule> keeper_held_ball() { return std::make_unique<KeeperHolding>(); }

}  // namespace autoref::judge::ground_truth
