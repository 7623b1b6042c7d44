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
// If the ball would have got too far within this time after the end of play, the call was early.
constexpr double kContactLead_s = 0.05;

// The kicker of a restart touches the ball, again or still, once it has been more than 50 mm away
// from its position, and before another robot has (Laws 2014, law 9, decision 1; 2026, Double
// Touch). In 2026, not at penalty kicks.
class DoubleTouch final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const Play& play = scene.play;
    if (play.count != count_) begin(play);
    const bool is_2026 = scene.rules.edition == Edition::kRules2026;
    if (is_over_ || !play.is_on || !play.taker || (is_2026 && play.is_penalty())) return;
    const bool is_out = inside_m(scene.field, scene.now.ball.position_m) < 0;
    for (const sim::Touch& touch : scene.touches) {
      if (is_out && inside_m(scene.field, touch.ball_m) < 0) break;
      touched(scene, touch, all);
    }
    farthest_m_ = std::max(farthest_m_, (scene.now.ball.position_m - play.ball_from_m).norm());
  }

 private:
  void begin(const Play& play) {
    count_ = play.count;
    kicker_.reset();
    farthest_m_ = 0;
    is_over_ = is_near_reported_ = false;
    reported_at_.reset();
  }

  void touched(const Scene& scene, const sim::Touch& touch, TrueEvents& all) {
    if (!kicker_) kicker_ = touch.robot;
    is_over_ = is_over_ || touch.robot != *kicker_ || touch.robot.side != scene.play.taker;
    if (is_over_) return;
    farthest_m_ = std::max(farthest_m_, (touch.ball_m - scene.play.ball_from_m).norm());
    const double excess_m = farthest_m_ - scene.rules.in_play_m;
    if (reported_at_) {
      if (excess_m > kAgainMargin_m) all[*reported_at_].is_borderline = false;
      return;
    }
    if (excess_m <= 0 && is_near_reported_) return;
    is_near_reported_ = excess_m > -kAgainMargin_m;
    if (excess_m > 0) reported_at_ = all.size();
    add_measured(
        all,
        {"attacker_double_touched_ball", scene.time_s, touch.robot.side, touch.robot, touch.ball_m},
        excess_m, kAgainMargin_m);
  }

  int count_ = -1;
  std::optional<RobotId> kicker_;
  double farthest_m_ = 0;  // from where the ball lay
  bool is_over_ = false;   // another robot has touched the ball
  bool is_near_reported_ = false;
  std::optional<std::size_t> reported_at_;  // index of the event
};

class Dribbling final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const bool is_out = inside_m(scene.field, scene.now.ball.position_m) < 0;
    if (!scene.play.is_on || is_out) return;
    for (const Contact& contact : scene.ball.contacts()) {
      const double path_m = (scene.now.ball.position_m - contact.ball_from_m).norm();
      const double excess_m = path_m - scene.rules.dribbling_m;
      if (excess_m <= -kDribblingMargin_m) continue;
      TrueEvent dribble{"bot_dribbled_ball_too_far", scene.time_s, contact.robot.side,
                        contact.robot, scene.now.ball.position_m};
      if (excess_m <= 0 && is_prevented(scene, contact, excess_m)) {
        dribble.standing = Standing::kPrevented;
        all.push_back(dribble);
      }
      int& reported = excess_m > 0 ? reported_ : nearly_reported_;
      if (reported == contact.count) {
        // Near the limit only if it ends there.
        if (excess_m > kDribblingMargin_m) all[reported_at_].is_borderline = false;
        continue;
      }
      reported = contact.count;
      if (excess_m > 0) reported_at_ = all.size();
      add_measured(all, dribble, excess_m, kDribblingMargin_m);
    }
  }

 private:
  // Whether the referee has just ended play while the ball was about to get too far.
  static bool is_prevented(const Scene& scene, const Contact& contact, double excess_m) {
    const Vec2 path_m = scene.now.ball.position_m - contact.ball_from_m;
    const double away_mps = scene.now.ball.velocity_mps.dot(direction_of(path_m, Vec2(1.0, 0.0)));
    return scene.play.ends_now && excess_m + kContactLead_s * away_mps > 0;
  }

  int reported_ = 0;
  std::size_t reported_at_ = 0;  // index of the event
  int nearly_reported_ = 0;
};

class KeeperHolding final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    if (!scene.play.is_on || !scene.play.in_play) {
      since_s_ = {{scene.time_s, scene.time_s}};
      return;
    }
    for (const Side side : kSides) watch(scene, side, all);
  }

 private:
  void watch(const Scene& scene, Side side, TrueEvents& all) {
    if (!is_keepers_ball(scene, side)) {
      since_s_[side] = scene.time_s;
      is_reported_[side] = false;
      return;
    }
    if (is_reported_[side]) return;
    const double excess_s = scene.time_s - since_s_[side] - scene.rules.keeper_holding_s;
    const bool is_prevented = scene.play.ends_now && excess_s > -kHoldingMargin_s;
    if (excess_s <= 0 && !is_prevented) return;
    is_reported_[side] = true;
    TrueEvent held{"keeper_held_ball", scene.time_s, side, RobotId{side, scene.keepers[side]},
                   scene.now.ball.position_m};
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
