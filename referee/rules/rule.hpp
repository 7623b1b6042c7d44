// A rule: the states in which it is active, and its searches for offences and other events.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"
#include "referee/state.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::referee {

// Returns what a rule finds in this frame, if anything. Called once per frame in the rule's states,
// unless an earlier rule has changed the state. It may change only its own records in
// `state.watch`.
using Search = std::optional<Finding> (*)(RefereeState& state, const RefereeInput& input);

struct RuleSearch {
  States active_in{};
  Search find = nullptr;
};

class Rule {
 public:
  constexpr Rule(States active_in, Search search) : Rule({RuleSearch{active_in, search}}) {}
  // A rule makes up to three searches, in this order.
  constexpr Rule(std::initializer_list<RuleSearch> searches) {
    for (const RuleSearch& search : searches) searches_.at(size_++) = search;
  }

  constexpr std::span<const RuleSearch> searches() const { return {searches_.data(), size_}; }

  // The first finding in the machine's current state, if any.
  std::optional<Finding> find(RefereeState& state, const RefereeInput& input) const;

 private:
  std::array<RuleSearch, 3> searches_{};
  std::size_t size_ = 0;
};

// Declares kGoalRule and the other rules; each is defined in its own file.
#define AUTOREF_RULE(id, ...) extern const Rule id##Rule;
#include "soccer/rules/rules.def"
#undef AUTOREF_RULE

// The rule on the kicks of a shoot-out. It applies whatever rules are in force, and is called after
// the other rules.
extern const Rule kShootoutRule;

struct ListedRule {
  RuleId id;
  const Rule* rule;
};

// All rules in the order of rules.def, in which they are called. Rules not in force are skipped.
std::span<const ListedRule> rules();

}  // namespace autoref::referee
