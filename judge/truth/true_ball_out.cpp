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
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (!frame.play.is_on) return;
    if (const auto crossing = find_crossing(frame.field, frame.before.ball, frame.now.ball)) {
      if (!is_failed_penalty(frame, *crossing)) all.push_back(event(frame, *crossing));
    } else if (frame.play.ends_now && inside_m(frame.field, frame.now.ball.position_m) >= 0) {
      foresee(frame, all);
    }
  }

 private:
  // A penalty kick that does not score has failed; another rule reports that.
  static bool is_failed_penalty(const TrueFrame& frame, const Crossing& crossing) {
    if (!frame.play.is_penalty() || !frame.may_penalty_fail()) return false;
    return !crossing.into_goal || (frame.is_shootout() && crossing.end == frame.play.taker);
  }

  static void foresee(const TrueFrame& frame, TrueEvents& all) {
    // Extrapolates the ball's path: play has ended, so the true crossing will never be seen.
    sim::BallState soon = frame.now.ball;
    soon.position_m += kExitLead_s * soon.velocity_mps;
    std::optional<Crossing> crossing = find_crossing(frame.field, frame.now.ball, soon);
    Standing standing = Standing::kPrevented;
    if (!crossing && inside_m(frame.field, frame.now.ball.position_m) < kNearlyOut_m) {
      crossing = nearly(frame);
      standing = Standing::kNearMiss;
    }
    if (!crossing) return;
    TrueEvent soon_out = event(frame, *crossing);
    soon_out.time_s = frame.time_s;
    soon_out.standing = standing;
    all.push_back(soon_out);
  }

  // The crossing of the ball if it were a little farther out.
  static std::optional<Crossing> nearly(const TrueFrame& frame) {
    sim::BallState beyond = frame.now.ball;
    const Vec2& at_m = beyond.position_m;
    const bool at_goal_line = frame.field.half_length_m() - std::abs(at_m.x()) <
                              frame.field.half_width_m() - std::abs(at_m.y());
    const Vec2 outwards = at_goal_line ? Vec2(std::copysign(1.0, at_m.x()), 0.0)
                                       : Vec2(0.0, std::copysign(1.0, at_m.y()));
    beyond.position_m += 2 * kNearlyOut_m * outwards;
    return find_crossing(frame.field, frame.now.ball, beyond);
  }

  static TrueEvent event(const TrueFrame& frame, const Crossing& crossing) {
    TrueEvent event = crossing.into_goal        ? goal(frame, crossing)
                      : crossing.over_goal_line ? over_goal_line(frame, crossing)
                                                : over_touch_line(frame);
    // Interpolate back to the time of the crossing within the frame.
    event.time_s = frame.time_s - (1 - crossing.share) * frame.frame_s;
    if (!event.position_m) event.position_m = crossing.point_m;
    event.is_in_air = crossing.height_m > 0;
    return event;
  }

  static TrueEvent over_touch_line(const TrueFrame& frame) {
    TrueEvent out;
    out.name = "throw_in";
    if (frame.ball.last() && !frame.ball.is_last_shared()) {
      out.robot = frame.ball.last()->robot;
      out.offender = out.robot->side;
    }
    return out;
  }

  static TrueEvent over_goal_line(const TrueFrame& frame, const Crossing& crossing) {
    TrueEvent out = over_touch_line(frame);
    out.name = out.offender == crossing.end ? "corner_kick" : "goal_kick";
    if (frame.ball.is_last_shared()) out.or_name = "corner_kick";
    if (!frame.rules.has(RuleId::kAimlessKick) || !out.offender || !is_aimless(frame, crossing)) {
      return out;
    }
    out.name = "aimless_kick";
    out.position_m = frame.ball.last()->ball_m;
    return out;
  }

  static bool is_aimless(const TrueFrame& frame, const Crossing& crossing) {
    const BallTouch& kick = *frame.ball.last();
    const bool from_kickoff = frame.play.is_kickoff() && !frame.ball.has_second_robot_touched();
    return !from_kickoff && crossing.end != kick.robot.side &&
           goal_sign(kick.robot.side) * kick.ball_m.x() > 0;
  }

  static TrueEvent goal(const TrueFrame& frame, const Crossing& crossing) {
    const Side conceded = crossing.end;
    const Side scorer = opponent_of(conceded);
    TrueEvent goal;
    goal.name = goal_name(frame, conceded);
    goal.offender = goal.name == "free_kick_own_goal" ? conceded : scorer;
    const double height_m = shot_height_m(frame, scorer);
    goal.is_borderline = std::abs(height_m - frame.rules.chip_height_m) < kNearHeight_m;
    return goal;
  }

  static std::string_view goal_name(const TrueFrame& frame, Side conceded) {
    const Side scorer = opponent_of(conceded);
    const bool straight = frame.ball.first() && !frame.ball.has_second_robot_touched();
    const bool is_free_kick = frame.play.taker.has_value() && !frame.play.is_penalty();
    if (straight && is_free_kick && frame.play.taker == conceded &&
        frame.rules.has(RuleId::kFreeKickOwnGoal)) {
      return "free_kick_own_goal";
    }
    if (straight && frame.play.restart.kind == CommandKind::kIndirectFree &&
        frame.play.taker == scorer && frame.rules.has(RuleId::kIndirectGoal)) {
      return "indirect_goal";
    }
    const bool too_high = shot_height_m(frame, scorer) > frame.rules.chip_height_m;
    // In a shoot-out, no free kick can follow, so the kick has failed.
    if (too_high && frame.rules.has(RuleId::kChippedGoal))
      return frame.is_shootout() ? "penalty_kick_failed" : "chipped_goal";
    const bool has_fouled = frame.time_s - frame.fouled_s[scorer] <= frame.rules.goal_after_foul_s;
    // "The restrictions defined for scoring goals ... do not apply here" (2026, Penalty Kick).
    if ((too_high || has_fouled || has_surplus(frame, scorer)) && !frame.play.is_penalty() &&
        frame.rules.has(RuleId::kInvalidGoal)) {
      return "invalid_goal";
    }
    return "goal";
  }

  static double shot_height_m(const TrueFrame& frame, Side scorer) {
    const Heights& heights = frame.ball.heights(scorer);
    return frame.rules.has(RuleId::kChippedGoal) ? heights.of_shot_m.value_or(0.0)
                                                 : heights.since_touch_m;
  }
};

}  // namespace

std::unique_ptr<GroundTruthRule> ball_out() { return std::make_unique<BallOut>(); }

}  // namespace autoref::judge::ground_truth
