// Robots too close to the ball or the defence area before a restart is taken (2026 rules).
#include "judge/truth/ground_truth_rules.hpp"
#include "judge/truth/outline.hpp"
#include "soccer/units.hpp"

namespace autoref::judge::ground_truth {
namespace {

// The ball's radius: the rules leave open whether distances end at its centre or its surface.
constexpr double kRestartMargin_m = 25_mm;

// 2026 rules, "Attacker Too Close To Defense Area": during stop, and during free kicks until the
// ball is in play. A team's grace period starts with the stop, however late a robot arrives, and
// starts again with the team's first foul. Kick-offs and penalty kicks have their own positions.
class AttackersNearArea final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const TruePlay& play = frame.play;
    const bool is_free_kick =
        play.is_on && !play.in_play && play.taker && !play.is_kickoff() && !play.is_penalty();
    if (!play.is_stop && !is_free_kick) return;
    if (play.is_stop && awaits_kickoff(frame.signal)) return;
    if (play.stop_count != stop_) begin(play);
    for (const Side side : kSides) {
      if (fouls_[side] == frame.rules.area_fouls_per_halt) continue;
      if (near_.watch(frame, side, nearest(frame, side), all)) ++fouls_[side];
    }
  }

 private:
  static bool awaits_kickoff(const RefereeSignal& signal) {
    return signal.next_command && signal.next_command->kind == CommandKind::kPrepareKickoff;
  }

  void begin(const TruePlay& play) {
    stop_ = play.stop_count;
    fouls_ = {};
    for (const Side side : kSides) near_.begin_grace(side, play.stop_began_s);
  }

  static WorstRobot nearest(const TrueFrame& frame, Side side) {
    WorstRobot worst;
    for_each_robot(frame.now, side, [&](RobotId id, const sim::RobotState& robot) {
      const Reach reach = reach_to_area(frame.field, opponent_of(side), robot);
      worst.consider(id, robot, frame.rules.attacker_to_area_m - reach.nearest_m);
    });
    return worst;
  }

  int stop_ = -1;
  PerSide<int> fouls_;  // number of fouls in this stop and the following free kick
  TeamFoul near_{"attacker_stays_near_area", kRestartMargin_m, &RuleBook::attacker_grace_s};
};

// 2026 rules, "Defender Too Close To Kick Point": during the opponents' kick-off or free kick,
// until the ball is in play.
class OpponentsNearRestart final : public GroundTruthRule {
 public:
  void watch(const TrueFrame& frame, TrueEvents& all) override {
    const TruePlay& play = frame.play;
    if (!play.is_on || play.in_play || !play.taker || play.is_penalty()) return;
    const Side side = opponent_of(*play.taker);
    WorstRobot worst;
    for_each_robot(frame.now, side, [&](RobotId id, const sim::RobotState& robot) {
      const double gap_m = hull_to_ball_m(robot, frame.now.ball);
      worst.consider(id, robot, frame.rules.opponents_to_ball_m - gap_m);
    });
    near_.watch(frame, side, worst, all);
  }

 private:
  TeamFoul near_{"defender_too_close_to_kick_point", kRestartMargin_m};
};

}  // namespace

std::unique_ptr<GroundTruthRule> attacker_stays() { return std::make_unique<AttackersNearArea>(); }
std::unique_ptr<GroundTruthRule> opponents_near_restart() {
  return std::make_unique<OpponentsNearRestart>();
}

}  // namespace autoref::judge::ground_truth
