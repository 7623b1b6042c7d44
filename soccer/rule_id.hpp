// The referee's rules by name: what a rule book contains and a game file switches on or off.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace autoref {

// In the order in which the referee checks them.
enum class RuleId : std::uint8_t {
#define AUTOREF_RULE(id, ...) id,
#include "soccer/rules.def"
#undef AUTOREF_RULE
};

#define AUTOREF_RULE(...) +1  // NOLINT(bugprone-macro-parentheses): a sum
inline constexpr int kRuleCount = 0
#include "soccer/rules.def"
    ;
#undef AUTOREF_RULE

// The name in snake_case, as in game files: "attacker_double_touched_ball".
std::string_view name_of(RuleId rule);
std::optional<RuleId> find_rule(std::string_view name);

// The rules in force.
class RuleSet {
 public:
  constexpr RuleSet() = default;
  constexpr RuleSet(std::initializer_list<RuleId> rules) {
    for (const RuleId rule : rules) (*this)[rule] = true;
  }

  constexpr bool has(RuleId rule) const { return in_force_[static_cast<std::size_t>(rule)]; }
  // For switching a rule on or off.
  constexpr bool& operator[](RuleId rule) { return in_force_[static_cast<std::size_t>(rule)]; }
  bool operator==(const RuleSet&) const = default;

 private:
  std::array<bool, kRuleCount> in_force_{};
};

}  // namespace autoref
