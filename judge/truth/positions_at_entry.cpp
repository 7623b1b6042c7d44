// Robots at illegal positions when the ball enters play from a restart.
#include <algorithm>
#include <cmath>

#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// The ball's radius: the rules leave open whether distances end at its centre or its surface.
constexpr double kEntryMargin_m = 25_mm;

// The robot with the largest position violation.
struct Worst {
  std::optional<RobotId> robot;
  Vec2 position_m{0, 0};
  double excess_m = -kEntryMargin_m;

  void consider(RobotId id, const sim::RobotState& state, double its_excess_m) {
    if (its_excess_m <= excess_m) return;
    robot = id;
    position_m = state.position_m;
    excess_m = its_excess_m;
  }
};

// Counts how often the current restart has been retaken in a row. After the last retake that the
// rule book allows, play continues regardless of the robots' positions.
class Retakes {
 public:
  void enter(const TruePlay& play) {
    const bool is_again = was_wrong_ && play.stops == stops_ + 1 && play.restart == restart_;
    count_ = is_again ? count_ + 1 : 0;
    stops_ = play.stops;
    restart_ = play.restart;
    was_wrong_ = false;
  }
  void be_wrong() { was_wrong_ = true; }
  bool may_be_taken_again(const RuleBook& rules) const { return count_ < rules.retakes; }

 private:
  int count_ = 0;
  int stops_ = 0;  // number of STOPs before the restart was last taken
  Command restart_;
  bool was_wrong_ = false;
};

class PositionsAtEntry final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    if (!frame.play.entered_now || !frame.play.taker || frame.play.is_penalty()) return;
    const Side taker = *frame.play.taker;
    const std::size_t reported = all.size();
    retakes_.enter(frame.play);
    const bool is_2026 = frame.rules.edition == Edition::kRules2026;
    if (frame.rules.has(RuleId::kAttackerTooCloseToDefenseArea) && !is_2026)
      near_area(frame, taker, all);
    if (frame.rules.has(RuleId::kDefenderTooCloseToKickPoint) && !is_2026)
      near_ball(frame, taker, all);
    if (frame.rules.has(RuleId::kKickoffPositions) && frame.play.is_kickoff()) half(frame, all);
    note_breaches(frame.rules, reported, all);
  }

 private:
  // Looks for violations that cause a retake, from index `reported` on, and removes them if no more
  // retakes are allowed.
  void note_breaches(const RuleBook& rules, std::size_t reported, TrueEvents& all) {
    const auto is_breach = [](const TrueEvent& event) {
      return event.standing == Standing::kTrue &&
             (event.name == "defender_too_close_to_kick_point" ||
              event.name == "kickoff_positions");
    };
    const auto from = all.begin() + static_cast<std::ptrdiff_t>(reported);
    if (!std::any_of(from, all.end(), is_breach)) return;
    if (retakes_.may_be_taken_again(rules)) {
      retakes_.be_wrong();
    } else {
      all.erase(std::remove_if(from, all.end(), is_breach), all.end());
    }
  }

  static void add(const TrueFrame& frame, std::string_view name, const Worst& worst,
                  TrueEvents& all) {
    if (!worst.robot) return;
    add_measured(all, {name, frame.time_s, worst.robot->side, worst.robot, worst.position_m},
                 worst.excess_m, kEntryMargin_m);
  }

  // The Laws 2014 say "a member of the kicker's team" (law 9), the paper "each robot" (section
  // 4.2). One call is enough for both sides, and the side taking the kick is checked first.
  static void near_area(const TrueFrame& frame, Side taker, TrueEvents& all) {
    for (const Side side : {taker, opponent_of(taker)}) {
      if (side != taker && frame.rules.edition == Edition::kLaws2014) return;
      Worst worst;
      for_each_robot(frame.now, side, [&](RobotId id, const sim::RobotState& robot) {
        const Reach reach = reach_to_area(frame.field, opponent_of(side), robot);
        worst.consider(id, robot, frame.rules.attacker_to_area_m - reach.nearest_m);
      });
      add(frame, "attacker_too_close_to_defense_area", worst, all);
      if (worst.excess_m > 0) return;
    }
  }

  // Checks positions just before the kick; distances are measured from the ball's original
  // position.
  static void near_ball(const TrueFrame& frame, Side taker, TrueEvents& all) {
    Worst worst;
    for_each_robot(frame.before, opponent_of(taker), [&](RobotId id, const auto& robot) {
      const double gap_m =
          distance_to_hull(frame.play.ball_from_m, robot.position_m, robot.heading);
      worst.consider(id, robot, frame.rules.opponents_to_ball_m - gap_m);
    });
    worst.position_m = frame.play.ball_from_m;
    add(frame, "defender_too_close_to_kick_point", worst, all);
  }

  // The kicker may be beyond the halfway line. If both sides break the rule, neither is solely at
  // fault.
  static void half(const TrueFrame& frame, TrueEvents& all) {
    Worst worst;
    PerSide<bool> is_wrong;
    for_each_robot(frame.before, [&](RobotId id, const sim::RobotState& robot) {
      if (frame.ball.first() && frame.ball.first()->robot == id) return;
      if (!is_on_field(frame.field, robot.position_m)) return;
      const double beyond_m = reach_into_half(opponent_of(id.side), robot).nearest_m;
      is_wrong[id.side] = is_wrong[id.side] || beyond_m > 0;
      worst.consider(id, robot, beyond_m);
    });
    const std::size_t reported = all.size();
    add(frame, "kickoff_positions", worst, all);
    if (all.size() == reported) return;
    all.back().position_m = frame.play.ball_from_m;
    if (is_wrong[Side::kWest] && is_wrong[Side::kEast]) all.back().offender.reset();
  }

  Retakes retakes_;
};

}  // namespace

std::unique_ptr<GroundTruthRule> positions_at_entry() {
  return std::make_unique<PositionsAtEntry>();
}

}  // namespace autoref::judge::ground_truth
