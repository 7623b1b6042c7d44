#include "referee/rules/in_goal.hpp"

#include "referee/geometry/ball_out.hpp"
#include "referee/geometry/restarts.hpp"

namespace autoref::referee {

std::optional<Side> conceding_side(const RefereeInput& input) {
  const std::optional<BallSight>& ball = input.ball;
  if (!ball || !is_in_goal(input.configuration.field, ball->position_m, ball->height_m)) {
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

}  // namespace autoref::referee
