#include "referee/rules/penalty_failed.hpp"

#include "referee/geometry/restarts.hpp"
#include "referee/machine/penalty_outcome.hpp"

namespace autoref::referee {

std::optional<Finding> find_penalty_failed(Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  if (!play.is_penalty() || !play.kicker) return std::nullopt;
  const std::optional<PenaltyFailure> failure = penalty_failure(memory, moment);
  if (!failure) return std::nullopt;
  const Configuration& c = moment.configuration;
  const Side defender = opponent_of(*play.kicker);
  const Vec2 ball_m = moment.ball ? moment.ball->position_m : play.place_m;
  Finding finding = finding_of(Event::kPenaltyFailed, RuleId::kPenaltyFailed, c.rules);
  finding.value = failure->value;
  finding.threshold = failure->threshold;
  finding.unit = failure->unit;
  finding.position_m = ball_m;
  finding.restart = {CommandKind::kDirectFree, defender};
  const Vec2 on_goal_line_m(c.field.goal_centre_m(defender).x(), ball_m.y());
  finding.ball_to_m = goal_kick_place(c.field, c.rules, defender, on_goal_line_m);
  finding.evidence = failure->evidence;
  return finding;
}

}  // namespace autoref::referee
