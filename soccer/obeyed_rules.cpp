#include "soccer/obeyed_rules.hpp"

#include <algorithm>

#include "soccer/rule_table.hpp"

namespace autoref {
namespace {

constexpr RuleSet kOfConduct = {RuleId::kKickoffPositions,
                                RuleId::kDefenderTooCloseToKickPoint,
                                RuleId::kAttackerTooCloseToDefenseArea,
                                RuleId::kPenaltyPositions,
                                RuleId::kBotCrashUnique,
                                RuleId::kBotPushedBot,
                                RuleId::kBotDribbledBallTooFar,
                                RuleId::kKeeperHeldBall,
                                RuleId::kDefenderInDefenseArea,
                                RuleId::kAttackerTouchedBallInDefenseArea,
                                RuleId::kAttackerDoubleTouchedBall,
                                RuleId::kBotKickedBallTooFast,
                                RuleId::kOffside,
                                RuleId::kAimlessKick,
                                RuleId::kBotTooFastInStop,
                                RuleId::kStopDistance,
                                RuleId::kBoundaryCrossing,
                                RuleId::kBotInterferedPlacement};

bool has_threshold(const RuleBook& rules, double RuleBook::*threshold) {
  const auto table = rule_table();
  return std::any_of(table.begin(), table.end(), [&](const RuleEntry& entry) {
    return entry.threshold == threshold && rules.has(entry.rule);
  });
}

}  // namespace

bool is_of_conduct(RuleId rule) { return kOfConduct.has(rule); }

RuleBook obeyed_rules(const RuleBook& match, const RuleBook& laws) {
  RuleBook obeyed = match;
  for (const RuleEntry& entry : rule_table()) {
    if (match.has(entry.rule) || !laws.has(entry.rule) || !is_of_conduct(entry.rule)) continue;
    obeyed.in_force[entry.rule] = true;
    if (entry.threshold != nullptr && !has_threshold(match, entry.threshold))
      obeyed.*entry.threshold = laws.*entry.threshold;
  }
  return obeyed;
}

}  // namespace autoref
