// Early termination: the game ends once a side has scored 10 goals and leads by more than one goal
// (2026). This rule takes effect after the GOAL command has been sent.
#include <fmt/format.h>
#include <algorithm>

#include "referee/machine/guards.hpp"
#include "referee/rules/rule.hpp"

namespace autoref::referee {
namespace {

std::optional<Finding> find_goal_lead(RefereeState& state, const RefereeInput& input) {
  const RuleBook& rules = input.configuration.rules;
  const PerSide<int>& goals = state.signal.goals;
  if (!wins_at_once(rules, goals) || state.signal.stage == Stage::kPostGame) return std::nullopt;
  const auto [less, more] = std::minmax(goals[Side::kWest], goals[Side::kEast]);
  Finding finding = finding_of(Event::kGoalLead, RuleId::kGoalLead, rules);
  finding.value = more;
  finding.threshold = rules.goals_to_win;
  finding.unit = "goals";
  finding.evidence = fmt::format("The score is {} to {}.", more, less);
  return finding;
}

}  // namespace

constinit const Rule kGoalLeadRule{{State::kDelayWait}, find_goal_lead};

}  // namespace autoref::referee
