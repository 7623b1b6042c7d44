// If a side kicks the ball straight from its own restart into its own goal, no goal is scored; the
// opponents get a corner kick (Laws 2014, law 13; in 2026 this is a goal). A touch by an unknown
// robot may have been made by a second robot. Penalty kicks are not affected, because they are
// taken at the other end.
#include <fmt/format.h>

#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/goals/in_goal.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_free_kick_own_goal(RefereeState& state, const RefereeInput& input) {
  const PlayState& play = state.play;
  const std::optional<Side> conceded = conceding_side(state.play, input);
  if (!conceded || play.kicker != conceded || !is_straight_from_restart(play)) return std::nullopt;
  Finding finding =
      finding_of(Event::kFreeKickOwnGoal, RuleId::kFreeKickOwnGoal, input.configuration.rules);
  if (input.last_touch.robot) finding.robots.push_back(*input.last_touch.robot);
  finding.offender = conceded;
  finding.position_m = input.ball->position_m;
  add_shot(finding, play.touches, input, opponent_of(*conceded));
  restart_with_corner_kick(finding, input, *conceded);
  finding.evidence = fmt::format(
      "The ball went from a restart of {} into its own goal, and no other robot touched it.",
      colour_of(*conceded));
  return finding;
}

}  // namespace

constinit const Rule kFreeKickOwnGoalRule{{State::kRun}, find_free_kick_own_goal};

}  // namespace autoref::referee
