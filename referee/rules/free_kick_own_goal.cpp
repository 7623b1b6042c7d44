#include "referee/rules/free_kick_own_goal.hpp"

#include <fmt/format.h>

#include "referee/machine/ball_in_play.hpp"
#include "referee/rules/in_goal.hpp"

namespace autoref::referee {

std::optional<Finding> find_free_kick_own_goal(Memory& memory, const Moment& moment) {
  const PlayMemory& play = memory.play;
  const std::optional<Side> conceded = conceding_side(moment);
  if (!conceded || play.kicker != conceded || !is_straight_from_restart(play)) return std::nullopt;
  Finding finding =
      finding_of(Event::kFreeKickOwnGoal, RuleId::kFreeKickOwnGoal, moment.configuration.rules);
  if (moment.last_touch.robot) finding.robots.push_back(*moment.last_touch.robot);
  finding.offender = conceded;
  finding.position_m = moment.ball->position_m;
  restart_with_corner_kick(finding, moment, *conceded);
  finding.evidence = fmt::format(
      "The ball went from a restart of {} into its own goal, and no other robot touched it.",
      name_of(*conceded));
  return finding;
}

}  // namespace autoref::referee
