#include "referee/rules/rule.hpp"

#include <array>

#include "referee/rules/attacker_near_area.hpp"
#include "referee/rules/attacker_stays_near_area.hpp"
#include "referee/rules/ball_leaves_field.hpp"
#include "referee/rules/card_due.hpp"
#include "referee/rules/crash.hpp"
#include "referee/rules/dribbling.hpp"
#include "referee/rules/goal.hpp"
#include "referee/rules/goal_lead.hpp"
#include "referee/rules/keeper_holding.hpp"
#include "referee/rules/kickoff_positions.hpp"
#include "referee/rules/no_progress.hpp"
#include "referee/rules/penalty_failed.hpp"
#include "referee/rules/penalty_positions.hpp"
#include "referee/rules/placement_interference.hpp"
#include "referee/rules/pushing.hpp"
#include "referee/rules/restart_distance.hpp"
#include "referee/rules/restart_not_taken.hpp"
#include "referee/rules/stop_distance.hpp"
#include "referee/rules/stop_speed.hpp"
#include "referee/rules/stuck_ball.hpp"
#include "referee/rules/team_timeout.hpp"
#include "referee/rules/too_many_robots.hpp"

namespace autoref::referee {

std::span<const Rule> rules() {
  static constexpr std::array kRules = {
      kKickoffPositionsRule,
      kRestartDistanceRule,
      kAttackerNearAreaRule,
      kAttackerStaysNearAreaRule,
      kPenaltyPositionsRule,
      kCrashRule,
      kPushingRule,
      kDribblingRule,
      kKeeperHoldingRule,
      kPenaltyFailedRule,
      kGoalRule,
      kBallLeavesFieldRule,
      kRestartNotTakenRule,
      kStuckBallRule,
      kNoProgressRule,
      kStopSpeedRule,
      kStopDistanceRule,
      kPlacementInterferenceRule,
      kTooManyRobotsRule,
      kRedCardRule,
      kYellowCardRule,
      kCardOverRule,
      kGoalLeadRule,
      kTimeoutRule,
      kTimeoutOverRule,
  };
  return kRules;
}

}  // namespace autoref::referee
