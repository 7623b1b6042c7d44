#include "referee/rules/rule.hpp"

#include <array>

#include "referee/rules/attacker_near_area.hpp"
#include "referee/rules/ball_leaves_field.hpp"
#include "referee/rules/card_due.hpp"
#include "referee/rules/goal.hpp"
#include "referee/rules/goal_lead.hpp"
#include "referee/rules/restart_not_taken.hpp"
#include "referee/rules/stuck_ball.hpp"
#include "referee/rules/team_timeout.hpp"
#include "referee/rules/too_many_robots.hpp"

namespace autoref::referee {

std::span<const Rule> rules() {
  static constexpr std::array<Rule, 12> kRules = {
      kAttackerNearAreaRule, kGoalRule,          kBallLeavesFieldRule, kRestartNotTakenRule,
      kStuckBallRule,        kTooManyRobotsRule, kRedCardRule,         kYellowCardRule,
      kCardOverRule,         kGoalLeadRule,      kTimeoutRule,         kTimeoutOverRule};
  return kRules;
}

}  // namespace autoref::referee
