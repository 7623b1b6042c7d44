// What a robot does that has the ball at its hull: double touch, dribbling, holding.
#include <algorithm>

#include "runner/judge/truth/outline.hpp"
#include "runner/judge/truth/truths.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::truth {
namespace {

constexpr double kDribblingMargin_m = 50_mm;  // where a contact began is as open as that
constexpr double kHoldingMargin_s = 0.2;
// A ball that gets too far so soon after play has ended was called early.
constexpr double kLead_s = 0.05;

// "Touches again": the ball has been away from the hull since.
class DoubleTouch final : public Truth {
 public:
  void watch(const Scene& scene, Happenings& all) override {
    const Play& play = scene.play;
    if (!play.is_on || !play.taker || !play.in_play || play.count == told_) return;
    if (!scene.ball.first() || scene.ball.has_second_robot_touched()) return;
    for (const Contact& contact : scene.ball.contacts()) {
      if (play.entered_now) continue;  // it may be the touch that moved the ball far enough
      const bool is_again = contact.is_new && contact.since_s > scene.ball.first()->time_s;
      // 2026: "remaining in contact" after that counts, too.
      const bool goes_on = scene.rules.edition == Edition::kRules2026 && contact.is_touching;
      if (!is_again && !goes_on) continue;
      told_ = play.count;
      all.push_back(
          {"double_touch", scene.time_s, contact.robot.side, contact.robot, contact.ball_from_m});
      return;
    }
  }

 private:
  int told_ = -1;
};

class Dribbling final : public Truth {
 public:
  void watch(const Scene& scene, Happenings& all) override {
    if (!scene.play.is_on) return;
    for (const Contact& contact : scene.ball.contacts()) {
      const double way_m = (scene.now.ball.position_m - contact.ball_from_m).norm();
      const double excess_m = way_m - scene.rules.dribbling_m;
      if (excess_m <= -kDribblingMargin_m) continue;
      Happening dribble{"dribbling", scene.time_s, contact.robot.side, contact.robot,
                        scene.now.ball.position_m};
      if (excess_m <= 0 && is_prevented(scene, contact, excess_m)) {
        dribble.standing = Standing::kPrevented;
        all.push_back(dribble);
      }
      int& told = excess_m > 0 ? told_ : nearly_told_;
      if (told == contact.count) continue;
      told = contact.count;
      add_measured(all, dribble, excess_m, kDribblingMargin_m);
    }
  }

 private:
  // The referee has just ended play while the ball was about to get so far.
  static bool is_prevented(const Scene& scene, const Contact& contact, double excess_m) {
    const Vec2 way_m = scene.now.ball.position_m - contact.ball_from_m;
    const double away_mps = scene.now.ball.velocity_mps.dot(direction_of(way_m, Vec2(1.0, 0.0)));
    return scene.play.ends_now && excess_m + kLead_s * away_mps > 0;
  }

  int told_ = 0;
  int nearly_told_ = 0;
};

// Laws 2014: in contact with its keeper, inside the area. 2026: inside the area, however it stays.
class KeeperHolding final : public Truth {
 public:
  void watch(const Scene& scene, Happenings& all) override {
    if (!scene.play.is_on || !scene.play.in_play) {
      since_s_ = {{scene.time_s, scene.time_s}};
      return;
    }
    for (const Side side : kSides) watch(scene, side, all);
  }

 private:
  static bool is_held(const Scene& scene, Side side) {
    if (distance_to_defence_area(scene.field, side, scene.now.ball.position_m) > 0) return false;
    if (scene.rules.edition == Edition::kRules2026) return true;
    const Contacts& contacts = scene.ball.contacts();
    return std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
      return contact.robot.side == side && scene.is_keeper(contact.robot);
    });
  }

  void watch(const Scene& scene, Side side, Happenings& all) {
    if (!is_held(scene, side)) {
      since_s_[side] = scene.time_s;
      is_told_[side] = false;
      return;
    }
    if (is_told_[side]) return;
    const double excess_s = scene.time_s - since_s_[side] - scene.rules.keeper_holding_s;
    const bool is_prevented = scene.play.ends_now && excess_s > -kHoldingMargin_s;
    if (excess_s <= 0 && !is_prevented) return;
    is_told_[side] = true;
    Happening held{"keeper_holding", scene.time_s, side, RobotId{side, scene.keepers[side]},
                   scene.now.ball.position_m};
    if (excess_s <= 0) held.standing = Standing::kPrevented;
    all.push_back(held);
  }

  PerSide<double> since_s_;
  PerSide<bool> is_told_;
};

}  // namespace

std::unique_ptr<Truth> double_touch() { return std::make_unique<DoubleTouch>(); }
std::unique_ptr<Truth> dribbling() { return std::make_unique<Dribbling>(); }
std::unique_ptr<Truth> keeper_holding() { return std::make_unique<KeeperHolding>(); }

}  // namespace autoref::runner::truth
