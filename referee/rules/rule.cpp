#include "referee/rules/rule.hpp"

#include <array>

#include "referee/rules/aimless_kick.hpp"
#include "referee/rules/attacker_in_area.hpp"
#include "referee/rules/attacker_near_area.hpp"
#include "referee/rules/ball_leaves_field.hpp"
#include "referee/rules/chip_goal.hpp"
#include "referee/rules/defender_in_area.hpp"
#include "referee/rules/double_touch.hpp"
#include "referee/rules/free_kick_own_goal.hpp"
#include "referee/rules/goal.hpp"
#include "referee/rules/goal_valid.hpp"
#include "referee/rules/indirect_goal.hpp"
#include "referee/rules/kick_speed.hpp"
#include "referee/rules/offside.hpp"
#include "referee/rules/restart_not_taken.hpp"
#include "referee/rules/stuck_ball.hpp"

namespace autoref::referee {

std::span<const Rule> rules() {
  static constexpr std::array kRules = {
      kAttackerNearAreaRule,
      kKickSpeedRule,
      kDoubleTouchRule,
      kDefenderInAreaRule,
      kAttackerInAreaRule,
      kOffsideRule,
      kFreeKickOwnGoalRule,
      kIndirectGoalRule,
      kChipGoalRule,
      kGoalValidRule,
      kGoalRule,
      kAimlessKickRule,
      kBallLeavesFieldRule,
      kRestartNotTakenRule,
      kStuckBallRule,
  };
  return kRules;
}

}  // namespace autoref::referee
