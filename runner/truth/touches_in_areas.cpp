// Robots that touch the ball in an area where they must not: defenders other than the keeper in
// their own one, attackers in the opponents'.
#include <algorithm>

#include "runner/truth/outline.hpp"
#include "runner/truth/truths.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::truth {
namespace {

constexpr double kMargin_m = 10_mm;

class TouchesInAreas final : public Truth {
 public:
  void watch(const Scene& scene, Happenings& all) override {
    if (!scene.play.is_on || !scene.play.in_play) return;
    for (const Contact& contact : scene.ball.contacts()) {
      const sim::RobotState* robot = find_robot(scene.now, contact.robot);
      if (!contact.is_touching || robot == nullptr) continue;
      if (scene.rules.has(RuleId::kDefenderInArea)) defending(scene, contact, *robot, all);
      if (scene.rules.has(RuleId::kAttackerInArea)) attacking(scene, contact, *robot, all);
    }
  }

 private:
  // Once per contact and name.
  struct Told {
    int contact = 0;
    std::string_view name;
    Standing standing = Standing::kTrue;
    bool operator==(const Told&) const = default;
  };

  void defending(const Scene& scene, const Contact& contact, const sim::RobotState& robot,
                 Happenings& all) {
    if (scene.is_keeper(contact.robot) || is_shoved(scene, contact.robot, robot)) return;
    const Reach reach = reach_to_area(scene.field, contact.robot.side, robot);
    add(scene, contact, "defender_in_area", -reach.farthest_m, all);
    const bool is_entirely = reach.farthest_m < 0;
    if (scene.rules.edition == Edition::kRules2026 || is_entirely) return;
    add(scene, contact, "defender_partly_in_area", -reach.nearest_m, all);
  }

  void attacking(const Scene& scene, const Contact& contact, const sim::RobotState& robot,
                 Happenings& all) {
    const Reach reach = reach_to_area(scene.field, opponent_of(contact.robot.side), robot);
    add(scene, contact, "attacker_in_area", -reach.nearest_m, all);
  }

  static bool is_shoved(const Scene& scene, RobotId id, const sim::RobotState& robot) {
    const auto& others = scene.now.robots[opponent_of(id.side)];
    return std::any_of(others.begin(), others.end(), [&robot](const sim::RobotState& other) {
      return are_in_contact(robot, other);
    });
  }

  void add(const Scene& scene, const Contact& contact, std::string_view name, double excess_m,
           Happenings& all) {
    const Told told{contact.count, name, excess_m > 0 ? Standing::kTrue : Standing::kNearMiss};
    if (excess_m <= -kMargin_m || std::find(told_.begin(), told_.end(), told) != told_.end()) {
      return;
    }
    told_.push_back(told);
    if (told_.size() > kRemembered) told_.erase(told_.begin());
    add_measured(all,
                 {name, scene.time_s, contact.robot.side, contact.robot, scene.now.ball.position_m},
                 excess_m, kMargin_m);
  }

  static constexpr std::size_t kRemembered = 64;  // contacts that may last at a time, and names
  std::vector<Told> told_;
};

}  // namespace

std::unique_ptr<Truth> touches_in_areas() { return std::make_unique<TouchesInAreas>(); }

}  // namespace autoref::runner::truth
