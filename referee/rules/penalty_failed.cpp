#include "referee/rules/penalty_failed.hpp"

#include "referee/geometry/restarts.hpp"
#include "referee/machine/penalty_outcome.hpp"

namespace autoref::referee {

std::optional<Finding> find_penalty_failed(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.is_penalty() || !play.kicker) return std::nullopt;
  const std::optional<PenaltyFailure> failure = penalty_failure(state, input);
  if (!failure) return std::nullopt;
  const Configuration& c = input.configuration;
  const Side defender = opponent_of(*play.kicker);
  const Vec2 ball_m = input.ball ? input.ball->position_m : play.position_m;
  Finding finding = finding_of(Event::kPenaltyFailed, RuleId::kPenaltyFailed, c.rules);
  finding.value = failure->value;
  finding.threshold = failure->threshold;
  finding.unit = failure->unit;
  finding.position_m = ball_m;
  finding.restart = {CommandKind::kDirectFree, defender};
  const Vec2 on_goal_line_m(c.field.goal_centre_m(defender).x(), ball_m.y());
  finding.ball_to_m = goal_kick_position(c.field, c.rules, defender, on_goal_line_m);
  finding.evidence = failure->evidence;
  return finding;
}

}  // namespace autoref::referee
