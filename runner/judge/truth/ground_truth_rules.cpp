#include "runner/judge/truth/ground_truth_rules.hpp"

namespace autoref::runner::ground_truth {
namespace {

struct Entry {
  RuleId rule;
  std::unique_ptr<GroundTruthRule> (*make)();
};

// Fouls first: a goal may depend on them.
constexpr Entry kEntries[] = {
    {RuleId::kBotKickedBallTooFast, bot_kicked_ball_too_fast},
    {RuleId::kAttackerDoubleTouchedBall, attacker_double_touched_ball},
    {RuleId::kBotDribbledBallTooFar, bot_dribbled_ball_too_far},
    {RuleId::kKeeperHeldBall, keeper_held_ball},
    {RuleId::kBotCrashUnique, bot_crash_unique},
    {RuleId::kBotPushedBot, bot_pushed_bot},
    {RuleId::kRestartNotTaken, untaken_restart},
    {RuleId::kBotTooFastInStop, bot_too_fast_in_stop},
    {RuleId::kStopDistance, stop_distance},
    {RuleId::kBotInterferedPlacement, bot_interfered_placement},
    {RuleId::kTooManyRobots, too_many_robots},
};

}  // namespace

std::vector<std::unique_ptr<GroundTruthRule>> ground_truth_rules_of(const RuleBook& rules) {
  std::vector<std::unique_ptr<GroundTruthRule>> makers;
  for (const Entry& entry : kEntries) {
    if (rules.has(entry.rule)) makers.push_back(entry.make());
  }
  if (rules.edition == Edition::kRules2026) {
    if (rules.has(RuleId::kAttackerTooCloseToDefenseArea)) makers.push_back(attacker_stays());
    if (rules.has(RuleId::kDefenderTooCloseToKickPoint)) makers.push_back(opponents_near_restart());
  }
  if (rules.has(RuleId::kDefenderInDefenseArea) ||
      rules.has(RuleId::kAttackerTouchedBallInDefenseArea)) {
    makers.push_back(touches_in_areas());
  }
  if (rules.has(RuleId::kStuckBall) || rules.has(RuleId::kNoProgressInGame)) {
    makers.push_back(stuck_ball());
  }
  if (rules.has(RuleId::kPenaltyKickFailed) || rules.has(RuleId::kPenaltyPositions)) {
    makers.push_back(penalty());
  }
  makers.push_back(positions_at_entry());
  makers.push_back(ball_out());
  return makers;
}

}  // namespace autoref::runner::ground_truth
