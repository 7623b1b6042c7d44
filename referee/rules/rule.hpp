// What every rule has: the states in which it watches, and a search for a breach or an event.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/make_finding.hpp"
#include "referee/referee_input.hpp"
#include "referee/state.hpp"
#include "soccer/rule_id.hpp"

namespace autoref::referee {

// What a rule finds in this frame, or none. It is asked once in every frame of its states that no
// earlier rule has ended, and may keep what it has seen in `state.watch`, nothing else.
using Search = std::optional<Finding> (*)(RefereeState& state, const RefereeInput& input);

struct Watch {
  States active_in{};
  Search find = nullptr;
};

class Rule {
 public:
  constexpr Rule(States active_in, Search search) : Rule({Watch{active_in, search}}) {}
  // Some rules find several things, in this order; three at most.
  constexpr Rule(std::initializer_list<Watch> watches) {
    for (const Watch& watch : watches) watches_.at(size_++) = watch;
  }

  constexpr std::span<const Watch> watches() const { return {watches_.data(), size_}; }

  // What it finds first in the state that the memory is in.
  std::optional<Finding> find(RefereeState& state, const RefereeInput& input) const;

 private:
  std::array<Watch, 3> watches_{};
  std::size_t size_ = 0;
};

// Every rule is defined in a file of its own: kGoalRule and so on.
#define AUTOREF_RULE(id, ...) extern const Rule id##Rule;
#include "soccer/rules.def"
#undef AUTOREF_RULE

// What is asked in a shoot-out, instead of all others and whatever rules are in force.
extern const Rule kShootoutRule;

struct AskedRule {
  RuleId id;
  const Rule* rule;
};

// All rules, in the order in which they are asked: that of rules.def. Those that the rule book does
// not have in force are not asked.
std::span<const AskedRule> rules();

}  // namespace autoref::referee
