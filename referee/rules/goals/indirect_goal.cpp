// A goal straight from an indirect free kick or a throw-in does not count if only the kicker has
// touched the ball. A goal kick follows (Laws 2014, laws 13 and 15). A touch by an unknown robot
// may have been made by a second robot.
#include <fmt/format.h>

#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/goals/in_goal.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_indirect_goal(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const std::optional<Side> conceded = conceding_side(state.play, input);
  if (!conceded || play.began_with.kind != CommandKind::kIndirectFree || play.kicker == conceded ||
      !is_straight_from_restart(play)) {
    return std::nullopt;
  }
  Finding finding =
      finding_of(Event::kIndirectGoal, RuleId::kIndirectGoal, input.configuration.rules);
  if (input.last_touch.robot) finding.robots.push_back(*input.last_touch.robot);
  finding.offender = play.kicker;
  finding.position_m = input.ball->position_m;
  add_shot(finding, play.touches, input, opponent_of(*conceded));
  restart_with_goal_kick(finding, input, *conceded);
  finding.evidence = fmt::format(
      "The ball went from an indirect kick of {} into the goal, and no other robot touched it.",
      colour_of(*play.kicker));
  return finding;
}

}  // namespace

constinit const Rule kIndirectGoalRule{{State::kRun}, find_indirect_goal};

}  // namespace autoref::referee
