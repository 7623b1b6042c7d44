#include "referee/rules/awarded_goal.hpp"

#include "referee/make_finding.hpp"

namespace autoref::referee {

Finding awarded_goal(const RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  Finding finding = finding_of(Event::kGoal, RuleId::kPenaltyKickFailed, rules);
  finding.threshold = 0;  // nothing was measured
  finding.unit = "";
  if (input.ball) finding.position_m = input.ball->position_m;
  finding.restart.side = opponent_of(*state.play.kicker);
  finding.ball_to_m = Vec2(0, 0);
  finding.evidence = "The defenders committed a foul at the penalty kick.";
  return finding;
}

}  // namespace autoref::referee
