// Once a penalty kick has failed (penalty_outcome.hpp), the penalty kick is over, and the defenders
// get a goal kick. If the defenders commit a foul, a goal is awarded (2026, Penalty Kick).
#include "referee/geometry/restarts.hpp"
#include "referee/machine/penalty_outcome.hpp"
#include "referee/rules/goals/in_goal.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_penalty_kick_failed(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  if (!play.is_penalty() || !play.kicker) return std::nullopt;
  if (is_goal_awarded(state, input)) return awarded_goal(state, input);
  const std::optional<PenaltyFailure> failure = penalty_failure(state, input);
  if (!failure) return std::nullopt;
  const Configuration& c = input.configuration;
  const Side defender = opponent_of(*play.kicker);
  const Vec2 ball_m = input.ball ? input.ball->position_m : play.position_m;
  Finding finding = finding_of(Event::kPenaltyKickFailed, RuleId::kPenaltyKickFailed, c.rules);
  finding.value = failure->value;
  finding.threshold = failure->threshold;
  finding.unit = failure->unit;
  finding.position_m = ball_m;
  finding.restart.side = defender;
  const Vec2 on_goal_line_m(c.field.goal_centre_m(defender).x(), ball_m.y());
  finding.ball_to_m = goal_kick_position(c.field, c.rules, defender, on_goal_line_m);
  finding.evidence = failure->evidence;
  return finding;
}

}  // namespace

constinit const Rule kPenaltyKickFailedRule{{State::kRun}, find_penalty_kick_failed};

}  // namespace autoref::referee
