// What every rule has: the states in which it watches, and a search for a breach or an event.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>

#include "referee/finding.hpp"
#include "referee/machine/referee_state.hpp"
#include "referee/referee_input.hpp"
#include "soccer/rule_id.hpp"

namespace autoref::referee {

// Some of the machine's states.
class States {
 public:
  constexpr States(std::initializer_list<State> states) {
    for (const State state : states) bits_ |= bit(state);
  }
  constexpr bool has(State state) const { return (bits_ & bit(state)) != 0; }

 private:
  static constexpr unsigned bit(State state) { return 1U << static_cast<unsigned>(state); }
  unsigned bits_ = 0;
};

struct Rule {
  RuleId id;
  States active_in;
  // What the rule finds in this frame, or none. It is asked once in every frame of its states that
  // no earlier rule has ended, and may keep what it has seen in `state.watch`, nothing else.
  std::optional<Finding> (*find)(RefereeState& state, const RefereeInput& input);
};

// All rules, in the order in which they are asked: what happens first on the field comes first. A
// robot too near to the area stands there before the kick whose ball goes out in the same frame,
// what forbids a goal comes before it, and a goal is judged before an exit. Those that the rule
// book does not have in force are not asked.
std::span<const Rule> rules();

}  // namespace autoref::referee
