// Penalty kicks: their outcome, and robots at illegal positions.
#include <algorithm>
#include <cmath>

#include "runner/judge/truth/crossing.hpp"
#include "runner/judge/truth/ground_truth_rules.hpp"
#include "runner/judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::runner::ground_truth {
namespace {

constexpr double kPenaltyMargin_m = 20_mm;
constexpr double kPushed_mps = 0.2_mps;  // the direction of slower balls is undefined

// By how much each side's worst robot violated its position just before the kick.
using Breaches = PerSide<double>;

// How far the keeper is off its goal line, measured to the front of its hull, or beside the goal,
// measured to its centre.
double off_its_line_m(const Field& field, Side side, const sim::RobotState& keeper) {
  const double in_front_m = field.half_length_m() - reach_into_half(side, keeper).farthest_m;
  const double behind_m = reach_into_half(side, keeper).nearest_m - field.half_length_m();
  const double beside_m = std::abs(keeper.position_m.y()) - field.half_goal_m();
  return std::max({in_front_m - field.line_width_m, behind_m, beside_m});
}

Breaches breaches_in(const Scene& scene) {
  const Side defender = opponent_of(*scene.play.taker);
  const double line_m =
      goal_sign(defender) * scene.play.ball_from_m.x() - scene.rules.penalty_clearance_m;
  Breaches breaches{{-1.0, -1.0}};
  for_each_robot(scene.before, [&](RobotId id, const sim::RobotState& robot) {
    if (scene.ball.first() && scene.ball.first()->robot == id) return;
    const bool is_their_keeper = id.side == defender && scene.is_keeper(id);
    if (!is_their_keeper && !is_on_field(scene.field, robot.position_m)) return;
    const double beyond_m = is_their_keeper ? off_its_line_m(scene.field, defender, robot)
                                            : reach_into_half(defender, robot).farthest_m - line_m;
    breaches[id.side] = std::max(breaches[id.side], beyond_m);
  });
  return breaches;
}

class Penalty final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    const Play& play = scene.play;
    if (!play.is_on || !play.is_penalty() || reported_ == play.count) return;
    if (play.entered_now) {
      breaches_ = breaches_in(scene);
      kicked_ = play.count;
    }
    const auto crossing = find_crossing(scene.field, scene.before.ball, scene.now.ball);
    const bool is_goal = crossing && crossing->into_goal && crossing->end != play.taker;
    if (!is_goal && !crossing && !is_turned(scene) && !is_too_late(scene)) return;
    reported_ = play.count;
    evaluate(scene, is_goal, all);
  }

 private:
  void evaluate(const Scene& scene, bool is_goal, TrueEvents& all) const {
    const Side attacker = *scene.play.taker;
    const bool is_kicked = kicked_ == scene.play.count;
    const Side side = is_goal ? attacker : opponent_of(attacker);
    const double excess_m = is_kicked ? breaches_[side] : -1.0;
    const double others_m = is_kicked ? breaches_[opponent_of(side)] : -1.0;
    if (scene.rules.has(RuleId::kPenaltyPositions)) {
      TrueEvent again;
      again.name = "penalty_positions";
      again.time_s = scene.time_s;
      // If both sides were wrong, neither is solely at fault.
      if (!(others_m > 0 && excess_m > 0)) again.offender = side;
      again.position_m = scene.play.ball_from_m;
      add_measured(all, again, excess_m, kPenaltyMargin_m);
    }
    if (is_goal || excess_m > 0 || !scene.rules.has(RuleId::kPenaltyKickFailed)) return;
    all.push_back(
        {"penalty_kick_failed", scene.time_s, attacker, std::nullopt, scene.now.ball.position_m});
  }

  // Turned by at least a right angle: the rest of the ball's path leads back.
  static bool is_turned(const Scene& scene) {
    const Vec2& former_mps = scene.before.ball.velocity_mps;
    if (former_mps.norm() < kPushed_mps) return false;
    return std::any_of(scene.touches.begin(), scene.touches.end(), [&](const sim::Touch& touch) {
      const bool is_defender = touch.robot.side != scene.play.taker;
      return is_defender && scene.is_keeper(touch.robot) && touch.ball_mps.dot(former_mps) <= 0;
    });
  }

  static bool is_too_late(const Scene& scene) {
    const double lasted_s = scene.time_s - scene.play.began_s;
    return lasted_s > scene.rules.penalty_time_s - scene.frame_s / 2;
  }

  Breaches breaches_;
  int kicked_ = -1;
  int reported_ = -1;
};

}  // namespace

std::unique_ptr<GroundTruthRule> penalty() { return std::make_unique<Penalty>(); }

}  // namespace autoref::runner::ground_truth
