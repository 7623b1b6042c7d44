// Fouls that do not stop the game (2026).
#include <algorithm>
#include <cmath>
#include <map>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// Decides when a non-stopping violation of the 2026 rules is raised: when it starts, and every 2 s
// while it lasts. After it has ended, the next one counts at once.
class NonStopping {
 public:
  // Call in each frame in which a robot commits the violation. Returns whether it is raised.
  bool is_raised(const Scene& scene, RobotId id) {
    const auto known = raised_s_.find(id);
    if (known != raised_s_.end() && !has_passed(scene, known->second, kRaisedAgain_s)) return false;
    raised_s_[id] = scene.time_s;
    return true;
  }
  // Ends the robot's violation, if any.
  void end(RobotId id) { raised_s_.erase(id); }
  bool lasts(RobotId id) const { return raised_s_.contains(id); }
  void clear() { raised_s_.clear(); }

 private:
  // 2026 rules, "Non-Stopping Fouls".
  static constexpr double kRaisedAgain_s = 2_s;
  std::map<RobotId, double> raised_s_;
};

constexpr double kKickMargin_mps = 0.2_mps;
constexpr double kOneKick_s = 0.2;  // touches within this time belong to the same kick

// The ball is too fast after a robot's kick or touch.
class KickSpeed final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    // A ball beyond the lines is out of play.
    if (!scene.play.is_on || inside_m(scene.field, scene.before.ball.position_m) < 0) return;
    double former_mps =
        speed_mps(scene, scene.before.ball.velocity_mps, scene.before.ball.vertical_mps);
    for (const sim::Touch& touch : scene.touches) {
      const double after_mps = speed_mps(scene, touch.ball_mps, touch.vertical_mps);
      // A fast ball that only glances off was not accelerated by this robot.
      if (after_mps > former_mps) evaluate(scene, touch, after_mps, all);
      former_mps = after_mps;
    }
    const sim::BallState& ball = scene.now.ball;
    const double now_mps = speed_mps(scene, ball.velocity_mps, ball.vertical_mps);
    if (now_mps <= scene.rules.kick_limit_mps) fast_.clear();
  }

 private:
  static double speed_mps(const Scene& scene, const Vec2& plane_mps, double vertical_mps) {
    if (scene.rules.edition != Edition::kRules2026) return plane_mps.norm();
    return std::sqrt(plane_mps.squaredNorm() + vertical_mps * vertical_mps);
  }

  void evaluate(const Scene& scene, const sim::Touch& touch, double speed_mps, TrueEvents& all) {
    const double excess_mps = speed_mps - scene.rules.kick_limit_mps;
    if (excess_mps <= -kKickMargin_mps || is_same(scene, touch.robot, excess_mps > 0)) return;
    (excess_mps > 0 ? raised_s_ : nearly_s_) = scene.time_s;
    if (excess_mps > 0) kicker_ = touch.robot;
    TrueEvent kick{"bot_kicked_ball_too_fast", scene.time_s, touch.robot.side, touch.robot,
                   touch.ball_m};
    kick.is_in_air = touch.vertical_mps > 0;
    add_measured(all, kick, excess_mps, kKickMargin_mps);
  }

  // Under the Laws, the referee ends play with the kick. Under the 2026 rules play continues:
  // another kick by the same robot counts once the ball has been slow enough, or after 2 s.
  bool is_same(const Scene& scene, RobotId kicker, bool is_foul) {
    const bool is_raised = scene.time_s - raised_s_ < kOneKick_s;
    if (!is_foul) return is_raised || scene.time_s - nearly_s_ < kOneKick_s;
    if (scene.rules.edition != Edition::kRules2026) return is_raised;
    return (is_raised && kicker_ == kicker) || !fast_.is_raised(scene, kicker);
  }

  double raised_s_ = -kOneKick_s;
  double nearly_s_ = -kOneKick_s;  // of the latest near miss
  std::optional<RobotId> kicker_;  // of the latest foul
  NonStopping fast_;               // robots whose kick is still too fast
};

constexpr double kAreaMargin_m = 10_mm;

// Robots that illegally touch the ball in a defence area: defenders other than the keeper in their
// own area, attackers in the opponents' area.
class TouchesInAreas final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    for_each_robot(scene.now, [&](RobotId id, const sim::RobotState& robot) {
      if (!scene.ball.has_contact(id) || inside_theirs_m(scene, id, robot) <= 0) attacks_.end(id);
    });
    if (!scene.play.is_on) attacks_.clear();
    // The touch that brings the ball into play does not count.
    if (!scene.play.is_on || !scene.play.in_play || scene.play.entered_now) return;
    for (const Contact& contact : scene.ball.contacts()) {
      const sim::RobotState* robot = find_robot(scene.now, contact.robot);
      if (robot == nullptr) continue;
      if (contact.is_touching && scene.rules.has(RuleId::kDefenderInDefenseArea)) {
        defending(scene, contact, *robot, all);
      }
      if (scene.rules.has(RuleId::kAttackerTouchedBallInDefenseArea)) {
        attacking(scene, contact, *robot, all);
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

  void defending(const Scene& scene, const Contact& contact, const sim::RobotState& robot,
                 TrueEvents& all) {
    if (scene.is_keeper(contact.robot)) return;
    const Reach reach = reach_to_area(scene.field, contact.robot.side, robot);
    add(scene, contact, "defender_in_defense_area", -reach.farthest_m, all);
    const bool is_entirely = reach.farthest_m < 0;
    if (scene.rules.edition == Edition::kRules2026 || is_entirely) return;
    add(scene, contact, "defender_in_defense_area_partially", -reach.nearest_m, all);
  }

  // How far the robot's hull extends into the opponents' area.
  static double inside_theirs_m(const Scene& scene, RobotId id, const sim::RobotState& robot) {
    return -reach_to_area(scene.field, opponent_of(id.side), robot).nearest_m;
  }

  // Play continues, so a lasting touch is raised again.
  void attacking(const Scene& scene, const Contact& contact, const sim::RobotState& robot,
                 TrueEvents& all) {
    constexpr std::string_view kName = "attacker_touched_ball_in_defense_area";
    const double inside_m = inside_theirs_m(scene, contact.robot, robot);
    if (inside_m <= 0) {
      if (contact.is_touching) add(scene, contact, kName, inside_m, all);
      return;
    }
    const bool has_touched = contact.is_touching || attacks_.lasts(contact.robot);
    if (!has_touched || !attacks_.is_raised(scene, contact.robot)) return;
    add_measured(
        all, {kName, scene.time_s, contact.robot.side, contact.robot, scene.now.ball.position_m},
        inside_m, kAreaMargin_m);
  }

  void add(const Scene& scene, const Contact& contact, std::string_view name, double excess_m,
           TrueEvents& all) {
    const Told reported{contact.count, name, excess_m > 0 ? Standing::kTrue : Standing::kNearMiss};
    if (excess_m <= -kAreaMargin_m ||
        std::find(reported_.begin(), reported_.end(), reported) != reported_.end()) {
      return;
    }
    reported_.push_back(reported);
    if (reported_.size() > kRemembered) reported_.erase(reported_.begin());
    add_measured(all,
                 {name, scene.time_s, contact.robot.side, contact.robot, scene.now.ball.position_m},
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
