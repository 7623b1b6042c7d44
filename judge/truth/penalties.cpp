// Penalty kicks: their outcome, and robots at illegal positions.
//
// 2026: "A goal is awarded if the defending team commits any foul. A goal is not awarded if the
// attacking team violates any rule." If both do, the kick's outcome decides.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

constexpr double kPenaltyMargin_m = 20_mm;
constexpr double kPushed_mps = 0.2_mps;  // the direction of slower balls is undefined
// The fouls that may happen while the ball of a penalty kick is in play.
constexpr std::array<std::string_view, 8> kDeciding = {
    "bot_kicked_ball_too_fast", "bot_dribbled_ball_too_far",
    "keeper_held_ball",         "bot_crash_unique",
    "bot_crash_drawn",          "bot_pushed_bot",
    "defender_in_defense_area", "attacker_touched_ball_in_defense_area"};

// How far each side's worst robot was from a legal position just before the kick.
using Breaches = PerSide<double>;

// How far the keeper is off its goal line (measured to the front of its hull) or to the side of the
// goal (measured to its centre).
double off_its_line_m(const Field& field, Side side, const sim::RobotState& keeper) {
  const double in_front_m = field.half_length_m() - reach_into_half(side, keeper).farthest_m;
  const double behind_m = reach_into_half(side, keeper).nearest_m - field.half_length_m();
  const double beside_m = std::abs(keeper.position_m.y()) - field.half_goal_m();
  return std::max({in_front_m - field.line_width_m, behind_m, beside_m});
}

Breaches breaches_in(const TrueFrame& frame) {
  const Side defender = opponent_of(*frame.play.taker);
  const double line_m =
      goal_sign(defender) * frame.play.ball_from_m.x() - frame.rules.penalty_clearance_m;
  Breaches breaches{{-1.0, -1.0}};
  for_each_robot(frame.before, [&](RobotId id, const sim::RobotState& robot) {
    if (frame.ball.first() && frame.ball.first()->robot == id) return;
    const bool is_their_keeper = id.side == defender && frame.is_keeper(id);
    if (!is_their_keeper && !is_on_field(frame.field, robot.position_m)) return;
    const double beyond_m = is_their_keeper ? off_its_line_m(frame.field, defender, robot)
                                            : reach_into_half(defender, robot).farthest_m - line_m;
    breaches[id.side] = std::max(breaches[id.side], beyond_m);
  });
  return breaches;
}

class Penalty final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const TruePlay& play = frame.play;
    const bool is_played = play.is_on && play.is_penalty();
    if (!is_played) next_ = all.size();  // earlier fouls do not decide
    if (seen_ != play.count) begin(play);
    if (!is_played || reported_ == play.count) return;
    if (play.entered_now) {
      breaches_ = breaches_in(frame);
      kicked_ = play.count;
    }
    if (frame.rules.penalty_fouls_decide && is_decided(frame, all)) {
      reported_ = play.count;
      return;
    }
    const auto crossing = find_crossing(frame.field, frame.before.ball, frame.now.ball);
    const bool is_goal = crossing && crossing->into_goal && crossing->end != play.taker;
    const bool is_back = frame.rules.penalty_fouls_decide && is_moved_back(frame);
    if (!is_goal && !crossing && !is_turned(frame) && !is_back && !is_too_late(frame)) return;
    reported_ = play.count;
    evaluate(frame, is_goal, all);
  }

 private:
  void begin(const TruePlay& play) {
    seen_ = play.count;
    fouled_ = {};
    farthest_m_ = -std::numeric_limits<double>::infinity();
  }

  // Under the 2026 rules, returns whether a foul decides the kick, and reports the outcome if so.
  bool is_decided(const TrueFrame& frame, TrueEvents& all) {
    if (frame.play.entered_now && frame.rules.has(RuleId::kPenaltyPositions)) {
      report_breaches(frame, all);
    }
    note_fouls(all);
    const Side attacker = *frame.play.taker;
    if (fouled_[Side::kWest] == fouled_[Side::kEast]) return false;
    const std::string_view name = fouled_[attacker] ? "penalty_kick_failed" : "goal";
    all.push_back({name, frame.time_s, attacker, std::nullopt, frame.now.ball.position_m});
    return true;
  }

  void report_breaches(const TrueFrame& frame, TrueEvents& all) {
    const bool both = breaches_[Side::kWest] > 0 && breaches_[Side::kEast] > 0;
    const Side worst = breaches_[Side::kWest] > breaches_[Side::kEast] ? Side::kWest : Side::kEast;
    TrueEvent breach;
    breach.name = "penalty_positions";
    breach.time_s = frame.time_s;
    if (!both) breach.offender = worst;  // otherwise neither is solely at fault
    breach.position_m = frame.play.ball_from_m;
    add_measured(all, breach, breaches_[worst], kPenaltyMargin_m);
    for (const Side side : kSides) fouled_[side] = fouled_[side] || breaches_[side] > 0;
  }

  void note_fouls(const TrueEvents& all) {
    for (; next_ < all.size(); ++next_) {
      const TrueEvent& event = all[next_];
      const bool is_foul =
          event.standing == Standing::kTrue &&
          std::find(kDeciding.begin(), kDeciding.end(), event.name) != kDeciding.end();
      if (!is_foul) continue;
      for (const Side side : kSides) {
        if (event.offender.value_or(side) == side) fouled_[side] = true;
      }
    }
  }

  // "The ball has to only move towards the opponent goal": returns whether it has moved back by
  // more than the distance that brings it into play.
  bool is_moved_back(const TrueFrame& frame) {
    const Side attacker = *frame.play.taker;
    const double now_m = goal_sign(opponent_of(attacker)) * frame.now.ball.position_m.x();
    farthest_m_ = std::max(farthest_m_, now_m);
    const bool is_attackers = !frame.ball.last() || frame.ball.last()->robot.side == attacker;
    return is_attackers && farthest_m_ - now_m > frame.rules.in_play_m;
  }

  void evaluate(const TrueFrame& frame, bool is_goal, TrueEvents& all) const {
    const Side attacker = *frame.play.taker;
    const bool is_kicked = kicked_ == frame.play.count;
    const Side side = is_goal ? attacker : opponent_of(attacker);
    const double excess_m = is_kicked ? breaches_[side] : -1.0;
    const double others_m = is_kicked ? breaches_[opponent_of(side)] : -1.0;
    if (frame.rules.has(RuleId::kPenaltyPositions) && !frame.rules.penalty_fouls_decide) {
      TrueEvent again;
      again.name = "penalty_positions";
      again.time_s = frame.time_s;
      // If both sides broke the rules, neither is solely at fault.
      if (!(others_m > 0 && excess_m > 0)) again.offender = side;
      again.position_m = frame.play.ball_from_m;
      add_measured(all, again, excess_m, kPenaltyMargin_m);
    }
    const bool is_retaken = excess_m > 0 && !frame.rules.penalty_fouls_decide;
    if (is_goal || is_retaken || !frame.may_penalty_fail()) return;
    all.push_back(
        {"penalty_kick_failed", frame.time_s, attacker, std::nullopt, frame.now.ball.position_m});
  }

  // Whether the ball has turned by at least a right angle, so that the rest of its path leads back.
  static bool is_turned(const TrueFrame& frame) {
    const Vec2& former_mps = frame.before.ball.velocity_mps;
    if (former_mps.norm() < kPushed_mps) return false;
    return std::any_of(frame.touches.begin(), frame.touches.end(), [&](const sim::Touch& touch) {
      const bool is_defender = touch.robot.side != frame.play.taker;
      return is_defender && frame.is_keeper(touch.robot) && touch.ball_mps.dot(former_mps) <= 0;
    });
  }

  static bool is_too_late(const TrueFrame& frame) {
    const double lasted_s = frame.time_s - frame.play.began_s;
    return lasted_s > frame.rules.penalty_time_s - frame.frame_s / 2;
  }

  Breaches breaches_;
  int seen_ = -1;         // count of the latest play
  std::size_t next_ = 0;  // index of the next event to examine
  PerSide<bool> fouled_;
  double farthest_m_ = -std::numeric_limits<double>::infinity();
  int kicked_ = -1;
  int reported_ = -1;
};

}  // namespace

std::unique_ptr<GroundTruthRule> penalty() { return std::make_unique<Penalty>(); }

}  // namespace autoref::judge::ground_truth
