// "When the ball enters one of the goals, a goal is awarded to the appropriate team, the ball is
// placed in the center of the field, and a kickoff is signaled" (paper, section 4.2). Here, the
// kick-off is for the team that conceded. A ball in a goal counts for that goal's opponents, no
// matter who touched it last.
#include <fmt/format.h>
#include <cmath>

#include "referee/rules/goals/in_goal.hpp"
#include "referee/rules/rule.hpp"
#include "soccer/robot_shape.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_goal(RefereeState& state, const RefereeInput& input) {
  const Field& field = input.configuration.field;
  const std::optional<Side> conceded = conceding_side(state.play, input);
  if (!conceded) return std::nullopt;
  const Vec2& ball_m = input.ball->position_m;
  Finding finding = finding_of(Event::kGoal, RuleId::kGoal, input.configuration.rules);
  finding.value = std::abs(ball_m.x());
  finding.threshold = field.half_length_m() + kBallRadius_m;
  finding.unit = "m";
  if (input.last_touch.robot) finding.robots.push_back(*input.last_touch.robot);
  finding.position_m = ball_m;
  add_shot(finding, state.play.touches, input, opponent_of(*conceded));
  finding.restart.side = *conceded;
  finding.ball_to_m = Vec2(0, 0);
  finding.evidence = fmt::format(
      "The ball is in the goal of {}, {} from its centre and {} above the ground.",
      colour_of(*conceded), mm_text(std::abs(ball_m.y())), mm_text(input.ball->height_m));
  return finding;
}

}  // namespace

constinit const Rule kGoalRule{{State::kRun}, find_goal};

}  // namespace autoref::referee
