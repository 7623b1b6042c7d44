#include "runner/judge/truth/ground_truth_rules.hpp"

namespace autoref::runner::ground_truth {
namespace {

struct Entry {
  RuleId rule;
  std::unique_ptr<GroundTruthRule> (*make)();
};

// Fouls first: a goal may depend on them.
constexpr Entry kEntries[] = {
    {RuleId::kKickSpeed, kick_speed},
    {RuleId::kDoubleTouch, double_touch},
    {RuleId::kDribbling, dribbling},
    {RuleId::kKeeperHolding, keeper_holding},
    {RuleId::kCrash, crash},
    {RuleId::kPushing, pushing},
    {RuleId::kRestartNotTaken, untaken_restart},
    {RuleId::kStopSpeed, stop_speed},
    {RuleId::kStopDistance, stop_distance},
    {RuleId::kPlacementInterference, placement_interference},
    {RuleId::kTooManyRobots, too_many_robots},
};

}  // namespace

std::vector<std::unique_ptr<GroundTruthRule>> ground_truth_rules_of(const RuleBook& rules) {
  std::vector<std::unique_ptr<GroundTruthRule>> makers;
  for (const Entry& entry : kEntries) {
    if (rules.has(entry.rule)) makers.push_back(entry.make());
  }
  if (rules.edition == Edition::kRules2026) {
    if (rules.has(RuleId::kAttackerNearArea)) makers.push_back(attacker_stays());
    if (rules.has(RuleId::kRestartDistance)) makers.push_back(opponents_near_restart());
  }
  if (rules.has(RuleId::kDefenderInArea) || rules.has(RuleId::kAttackerInArea)) {
    makers.push_back(touches_in_areas());
  }
  if (rules.has(RuleId::kStuckBall) || rules.has(RuleId::kNoProgress)) {
    makers.push_back(stuck_ball());
  }
  if (rules.has(RuleId::kPenaltyFailed) || rules.has(RuleId::kPenaltyPositions)) {
    makers.push_back(penalty());
  }
  makers.push_back(positions_at_entry());
  makers.push_back(ball_out());
  return makers;
}

}  // namespace autoref::runner::ground_truth
