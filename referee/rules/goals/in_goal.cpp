#include "referee/rules/goals/in_goal.hpp"

#include <algorithm>

#include "referee/finding.hpp"
#include "referee/geometry/ball_out.hpp"
#include "referee/geometry/restarts.hpp"
#include "referee/rules/too_many_robots.hpp"
#include "soccer/robot_shape.hpp"

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

std::optional<Side> conceding_side(const PlayState& play, const RefereeInput& input) {
  const std::optional<BallSight>& ball = input.ball;
  if (!ball || play.lies_outside ||
      !is_in_goal(input.configuration.field, ball->position_m, ball->height_m)) {
    return std::nullopt;
  }
  return ball->position_m.x() < 0 ? Side::kWest : Side::kEast;
}

void restart_with_goal_kick(Finding& finding, const RefereeInput& input, Side defender) {
  const Configuration& c = input.configuration;
  finding.restart.side = defender;
  finding.ball_to_m = goal_kick_position(c.field, c.rules, defender, input.ball->position_m);
}

void restart_with_corner_kick(Finding& finding, const RefereeInput& input, Side defender) {
  const Configuration& c = input.configuration;
  const Side attacker = opponent_of(defender);
  finding.restart.side = attacker;
  finding.ball_to_m = corner_kick_position(c.field, c.rules, attacker, input.ball->position_m);
}

std::optional<double> top_since_touch_m(const TouchHistory& touches, Side scorer) {
  double highest_m = 0;
  for (int back = 0; touches.has(back) && touches.at(back).side; ++back) {
    highest_m = std::max(highest_m, touches.at(back).highest_m);
    if (touches.at(back).side == scorer) return highest_m + 2 * kBallRadius_m;
  }
  return std::nullopt;
}

void add_shot(Finding& finding, const TouchHistory& touches, const RefereeInput& input,
              Side scorer) {
  EventDetails& details = finding.details;
  details.robots = robots_on_field(input, scorer);
  if (touches.newest() != nullptr) details.kick_m = touches.newest()->ended_m;
  bool height_known = true;
  for (int back = 0; touches.has(back); ++back) {
    const BallTouch& touch = touches.at(back);
    height_known = height_known && touch.height_known;
    if (touch.side != scorer) continue;
    details.scorers_touched_s = touch.ended_s;
    const std::optional<double> top_m = top_since_touch_m(touches, scorer);
    if (top_m && (height_known || *top_m > 2 * kBallRadius_m)) details.ball_top_m = top_m;
    return;
  }
}

}  // namespace autoref::referee
