#include "referee/rules/rule.hpp"

#include <array>

#include "referee/rules/attacker_near_area.hpp"
#include "referee/rules/attacker_stays_near_area.hpp"
#include "referee/rules/ball_leaves_field.hpp"
#include "referee/rules/goal.hpp"
#include "referee/rules/kickoff_positions.hpp"
#include "referee/rules/no_progress.hpp"
#include "referee/rules/penalty_failed.hpp"
#include "referee/rules/penalty_positions.hpp"
#include "referee/rules/restart_distance.hpp"
#include "referee/rules/restart_not_taken.hpp"
#include "referee/rules/stuck_ball.hpp"

namespace autoref::referee {

std::span<const Rule> rules() {
  static constexpr std::array kRules = {
      kKickoffPositionsRule,
      kRestartDistanceRule,
      kAttackerNearAreaRule,
      kAttackerStaysNearAreaRule,
      kPenaltyPositionsRule,
      kPenaltyFailedRule,
      kGoalRule,
      kBallLeavesFieldRule,
      kRestartNotTakenRule,
      kStuckBallRule,
      kNoProgressRule,
  };
  return kRules;
}

}  // namespace autoref::referee
