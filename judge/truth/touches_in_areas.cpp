// Robots that illegally touch the ball in a defence area: defenders other than the keeper in their
// own area, attackers in the opponents' area.
#include <algorithm>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/non_stopping.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kAreaMargin_m = 10_mm;

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

std::unique_ptr<GroundTruthRule> touches_in_areas() { return std::make_unique<TouchesInAreas>(); }

}  // namespace autoref::judge::ground_truth
