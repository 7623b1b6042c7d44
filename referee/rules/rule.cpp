#include "referee/rules/rule.hpp"

namespace autoref::referee {

std::optional<Finding> Rule::find(RefereeState& state, const RefereeInput& input) const {
  for (const RuleSearch& search : searches()) {
    if (!search.active_in.has(state.machine_state)) continue;
    if (std::optional<Finding> found = search.find(state, input)) return found;
  }
  return std::nullopt;
}

std::span<const ListedRule> rules() {
  static constexpr std::array<ListedRule, kRuleCount> kRules = {{
#define AUTOREF_RULE(id, ...) {RuleId::id, &id##Rule},
#include "soccer/rules/rules.def"
#undef AUTOREF_RULE
  }};
  return kRules;
}

}  // namespace autoref::referee
