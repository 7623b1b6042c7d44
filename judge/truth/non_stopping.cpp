// Fouls that do not stop the game (2026).
#include <algorithm>
#include <cmath>
#include <map>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// Decides when a non-stopping violation of the 2026 rules is raised: when it starts, and every
// `foul_repeat_s` while it lasts. After it has ended, the next one counts immediately.
class NonStopping {
 public:
  // Call in each frame in which a robot commits the violation. Returns whether it is raised.
  bool is_raised(const TrueFrame& frame, RobotId id) {
    const auto known = raised_s_.find(id);
    if (known != raised_s_.end() && !has_passed(frame, known->second, frame.rules.foul_repeat_s))
      return false;
    raised_s_[id] = frame.time_s;
    return true;
  }
  // Ends the robot's violation, if any.
  void end(RobotId id) { raised_s_.erase(id); }
  bool lasts(RobotId id) const { return raised_s_.contains(id); }
  void clear() { raised_s_.clear(); }

 private:
  std::map<RobotId, double> raised_s_;
};

constexpr double kKickMargin_mps = 0.2_mps;
constexpr double kOneKick_s = 0.2;  // touches within this time belong to the same kick

// The ball is too fast after a robot's kick or touch.
class KickSpeed final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    // A ball beyond the lines is out of play.
    if (!frame.play.is_on || inside_m(frame.field, frame.before.ball.position_m) < 0) return;
    double former_mps =
        speed_mps(frame, frame.before.ball.velocity_mps, frame.before.ball.vertical_mps);
    for (const sim::Touch& touch : frame.touches) {
      const double after_mps = speed_mps(frame, touch.ball_mps, touch.vertical_mps);
      // A fast ball that only glances off the robot was not accelerated by it.
      if (after_mps > former_mps) evaluate(frame, touch, after_mps, all);
      former_mps = after_mps;
    }
    const sim::BallState& ball = frame.now.ball;
    const double now_mps = speed_mps(frame, ball.velocity_mps, ball.vertical_mps);
    if (now_mps <= frame.rules.kick_limit_mps) fast_.clear();
  }

 private:
  static double speed_mps(const TrueFrame& frame, const Vec2& plane_mps, double vertical_mps) {
    if (frame.rules.edition != Edition::kRules2026) return plane_mps.norm();
    return std::sqrt(plane_mps.squaredNorm() + vertical_mps * vertical_mps);
  }

  void evaluate(const TrueFrame& frame, const sim::Touch& touch, double speed_mps,
                TrueEvents& all) {
    const double excess_mps = speed_mps - frame.rules.kick_limit_mps;
    if (excess_mps <= -kKickMargin_mps || is_same(frame, touch.robot, excess_mps > 0)) return;
    (excess_mps > 0 ? raised_s_ : nearly_s_) = frame.time_s;
    if (excess_mps > 0) kicker_ = touch.robot;
    TrueEvent kick{"bot_kicked_ball_too_fast", frame.time_s, touch.robot.side, touch.robot,
                   touch.ball_m};
    kick.is_in_air = touch.vertical_mps > 0;
    add_measured(all, kick, excess_mps, kKickMargin_mps);
  }

  // Under the Laws, the referee stops play at the kick. Under the 2026 rules play continues:
  // another kick by the same robot counts once the ball has been slow enough, or after 2 s.
  bool is_same(const TrueFrame& frame, RobotId kicker, bool is_foul) {
    const bool is_raised = frame.time_s - raised_s_ < kOneKick_s;
    if (!is_foul) return is_raised || frame.time_s - nearly_s_ < kOneKick_s;
    if (frame.rules.edition != Edition::kRules2026) return is_raised;
    return (is_raised && kicker_ == kicker) || !fast_.is_raised(frame, kicker);
  }

  double raised_s_ = -kOneKick_s;
  double nearly_s_ = -kOneKick_s;  // time of the latest near miss
  std::optional<RobotId> kicker_;  // kicker of the latest foul
  NonStopping fast_;               // robots whose kick is still too fast
};

constexpr double kAreaMargin_m = 10_mm;

// Robots that illegally touch the ball in a defence area: defenders other than the keeper in their
// own area, attackers in the opponents' area.
class TouchesInAreas final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    for_each_robot(frame.now, [&](RobotId id, const sim::RobotState& robot) {
      if (!frame.ball.has_contact(id) || inside_theirs_m(frame, id, robot) <= 0) attacks_.end(id);
    });
    if (!frame.play.is_on) attacks_.clear();
    // The touch that brings the ball into play does not count.
    if (!frame.play.is_on || !frame.play.in_play || frame.play.entered_now) return;
    for (const Contact& contact : frame.ball.contacts()) {
      const sim::RobotState* robot = find_robot(frame.now, contact.robot);
      if (robot == nullptr) continue;
      if (contact.is_touching && frame.rules.has(RuleId::kDefenderInDefenseArea)) {
        defending(frame, contact, *robot, all);
      }
      if (frame.rules.has(RuleId::kAttackerTouchedBallInDefenseArea)) {
        attacking(frame, contact, *robot, all);
      }
    }
  }

 private:
  // Each event is reported once per contact and name.
  struct Told {
    int contact = 0;
    std::string_view name;
    Standing standing = Standing::kTrue;
    bool operator==(const Told&) const = default;
  };

  void defending(const TrueFrame& frame, const Contact& contact, const sim::RobotState& robot,
                 TrueEvents& all) {
    if (frame.is_keeper(contact.robot)) return;
    const Reach reach = reach_to_area(frame.field, contact.robot.side, robot);
    add(frame, contact, "defender_in_defense_area", -reach.farthest_m, all);
    const bool is_entirely = reach.farthest_m < 0;
    if (frame.rules.edition == Edition::kRules2026 || is_entirely) return;
    add(frame, contact, "defender_in_defense_area_partially", -reach.nearest_m, all);
  }

  // How far the robot's hull extends into the opponents' area.
  static double inside_theirs_m(const TrueFrame& frame, RobotId id, const sim::RobotState& robot) {
    return -reach_to_area(frame.field, opponent_of(id.side), robot).nearest_m;
  }

  // Play continues, so a lasting touch is raised again.
  void attacking(const TrueFrame& frame, const Contact& contact, const sim::RobotState& robot,
                 TrueEvents& all) {
    constexpr std::string_view kName = "attacker_touched_ball_in_defense_area";
    const double inside_m = inside_theirs_m(frame, contact.robot, robot);
    if (inside_m <= 0) {
      if (contact.is_touching) add(frame, contact, kName, inside_m, all);
      return;
    }
    const bool has_touched = contact.is_touching || attacks_.lasts(contact.robot);
    if (!has_touched || !attacks_.is_raised(frame, contact.robot)) return;
    add_measured(
        all, {kName, frame.time_s, contact.robot.side, contact.robot, frame.now.ball.position_m},
        inside_m, kAreaMargin_m);
  }

  void add(const TrueFrame& frame, const Contact& contact, std::string_view name, double excess_m,
           TrueEvents& all) {
    const Told reported{contact.count, name, excess_m > 0 ? Standing::kTrue : Standing::kNearMiss};
    if (excess_m <= -kAreaMargin_m ||
        std::find(reported_.begin(), reported_.end(), reported) != reported_.end()) {
      return;
    }
    reported_.push_back(reported);
    if (reported_.size() > kRemembered) reported_.erase(reported_.begin());
    add_measured(all,
                 {name, frame.time_s, contact.robot.side, contact.robot, frame.now.ball.position_m},
                 excess_m, kAreaMargin_m);
  }

  static constexpr std::size_t kRemembered = 64;  // bound on simultaneous contacts and names
  std::vector<Told> reported_;
  NonStopping attacks_;
};

}  // namespace

std::unique_ptr<GroundTruthRule> bot_kicked_ball_too_fast() {
  return std::make_unique<KickSpeed>();
}

std::unique_ptr<GroundTruthRule> touches_in_areas() { return std::make_unique<TouchesInAreas>(); }

}  // namespace autoref::judge::ground_truth
