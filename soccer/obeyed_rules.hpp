// The rules that a team keeps to: those in force, and those of the laws that its members know.
#pragma once

#include "soccer/rule_book.hpp"

namespace autoref {

// Whether a team can keep to the rule by what its robots do. The other rules say how a game
// proceeds: what scores, which restart follows, and when the game ends.
bool is_of_conduct(RuleId rule);

// `match` with the rules of conduct of `laws` added that the match does not enforce. Their
// thresholds are those of `laws`, unless the match enforces another rule with the same threshold.
// All else is the match's: the edition, restarts, penalty kicks and cards.
RuleBook obeyed_rules(const RuleBook& match, const RuleBook& laws);

}  // namespace autoref
