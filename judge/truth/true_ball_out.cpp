// The ball leaves the field: over a touch line, over a goal line or into a goal (valid or not).
#include <algorithm>
#include <cmath>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "judge/truth/robot_count.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// If the ball would leave the field within this time at constant velocity, the call was early.
constexpr double kExitLead_s = 0.1;
// If the ball's far edge comes this close to leaving the field, it is a near miss.
constexpr double kNearlyOut_m = 10_mm;
constexpr double kNearHeight_m = 20_mm;

class BallOut final : public GroundTruthRule {
 public:
  void watch(const Scene& scene, TrueEvents& all) override {
    if (!scene.play.is_on) return;
    if (const auto crossing = find_crossing(scene.field, scene.before.ball, scene.now.ball)) {
      if (!is_failed_penalty(scene, *crossing)) all.push_back(event(scene, *crossing));
    } else if (scene.play.ends_now && inside_m(scene.field, scene.now.ball.position_m) >= 0) {
      foresee(scene, all);
    }
  }

 private:
  // A penalty kick that does not score has failed, which another rule reports.
  static bool is_failed_penalty(const Scene& scene, const Crossing& crossing) {
    if (!scene.play.is_penalty() || !scene.may_penalty_fail()) return false;
    return !crossing.into_goal || (scene.is_shootout() && crossing.end == scene.play.taker);
  }

  static void foresee(const Scene& scene, TrueEvents& all) {
    // Dead reckoning: play has ended, so the true crossing will never be seen.
    sim::BallState soon = scene.now.ball;
    soon.position_m += kExitLead_s * soon.velocity_mps;
    std::optional<Crossing> crossing = find_crossing(scene.field, scene.now.ball, soon);
    Standing standing = Standing::kPrevented;
    if (!crossing && inside_m(scene.field, scene.now.ball.position_m) < kNearlyOut_m) {
      crossing = nearly(scene);
      standing = Standing::kNearMiss;
    }
    if (!crossing) return;
    TrueEvent soon_out = event(scene, *crossing);
    soon_out.time_s = scene.time_s;
    soon_out.standing = standing;
    all.push_back(soon_out);
  }

  // The crossing of the ball if it were a little farther out.
  static std::optional<Crossing> nearly(const Scene& scene) {
    sim::BallState beyond = scene.now.ball;
    const Vec2& at_m = beyond.position_m;
    const bool at_goal_line = scene.field.half_length_m() - std::abs(at_m.x()) <
                              scene.field.half_width_m() - std::abs(at_m.y());
    const Vec2 outwards = at_goal_line ? Vec2(std::copysign(1.0, at_m.x()), 0.0)
                                       : Vec2(0.0, std::copysign(1.0, at_m.y()));
    beyond.position_m += 2 * kNearlyOut_m * outwards;
    return find_crossing(scene.field, scene.now.ball, beyond);
  }

  static TrueEvent event(const Scene& scene, const Crossing& crossing) {
    TrueEvent event = crossing.into_goal        ? goal(scene, crossing)
                      : crossing.over_goal_line ? over_goal_line(scene, crossing)
                                                : over_touch_line(scene);
    // Interpolate back to the time of the crossing within the frame.
    event.time_s = scene.time_s - (1 - crossing.share) * scene.frame_s;
    if (!event.position_m) event.position_m = crossing.point_m;
    event.is_in_air = crossing.height_m > 0;
    return event;
  }

  static TrueEvent over_touch_line(const Scene& scene) {
    TrueEvent out;
    out.name = "throw_in";
    if (scene.ball.last() && !scene.ball.is_last_shared()) {
      out.robot = scene.ball.last()->robot;
      out.offender = out.robot->side;
    }
    return out;
  }

  static TrueEvent over_goal_line(const Scene& scene, const Crossing& crossing) {
    TrueEvent out = over_touch_line(scene);
    out.name = out.offender == crossing.end ? "corner_kick" : "goal_kick";
    if (scene.ball.is_last_shared()) out.or_name = "corner_kick";
    if (!scene.rules.has(RuleId::kAimlessKick) || !out.offender || !is_aimless(scene, crossing)) {
      return out;
    }
    out.name = "aimless_kick";
    out.position_m = scene.ball.last()->ball_m;
    return out;
  }

  static bool is_aimless(const Scene& scene, const Crossing& crossing) {
    const BallTouch& kick = *scene.ball.last();
    const bool from_kickoff = scene.play.is_kickoff() && !scene.ball.has_second_robot_touched();
    return !from_kickoff && crossing.end != kick.robot.side &&
           goal_sign(kick.robot.side) * kick.ball_m.x() > 0;
  }

  static TrueEvent goal(const Scene& scene, const Crossing& crossing) {
    const Side conceded = crossing.end;
    const Side scorer = opponent_of(conceded);
    TrueEvent goal;
    goal.name = goal_name(scene, conceded);
    goal.offender = goal.name == "free_kick_own_goal" ? conceded : scorer;
    const double height_m = shot_height_m(scene, scorer);
    goal.is_borderline = std::abs(height_m - scene.rules.chip_height_m) < kNearHeight_m;
    return goal;
  }

  static std::string_view goal_name(const Scene& scene, Side conceded) {
    const Side scorer = opponent_of(conceded);
    const bool straight = scene.ball.first() && !scene.ball.has_second_robot_touched();
    const bool is_free_kick = scene.play.taker.has_value() && !scene.play.is_penalty();
    if (straight && is_free_kick && scene.play.taker == conceded &&
        scene.rules.has(RuleId::kFreeKickOwnGoal)) {
      return "free_kick_own_goal";
    }
    if (straight && scene.play.restart.kind == CommandKind::kIndirectFree &&
        scene.play.taker == scorer && scene.rules.has(RuleId::kIndirectGoal)) {
      return "indirect_goal";
    }
    const bool too_high = shot_height_m(scene, scorer) > scene.rules.chip_height_m;
    // In a shoot-out no free kick can follow, so the kick has failed.
    if (too_high && scene.rules.has(RuleId::kChippedGoal))
      return scene.is_shootout() ? "penalty_kick_failed" : "chipped_goal";
    const bool has_fouled = scene.time_s - scene.fouled_s[scorer] <= scene.rules.goal_after_foul_s;
    // "The restrictions defined for scoring goals ... do not apply here" (2026, Penalty Kick).
    if ((too_high || has_fouled || has_surplus(scene, scorer)) && !scene.play.is_penalty() &&
        scene.rules.has(RuleId::kInvalidGoal)) {
      return "invalid_goal";
    }
    return "goal";
  }

  static double shot_height_m(const Scene& scene, Side scorer) {
    const Heights& heights = scene.ball.heights(scorer);
    return scene.rules.has(RuleId::kChippedGoal) ? heights.of_shot_m.value_or(0.0)
                                                 : heights.since_touch_m;
  }
};

}  // namespace

std::unique_ptr<GroundTruthRule> ball_out() { return std::make_unique<BallOut>(); }

}  // namespace autoref::judge::ground_truth
