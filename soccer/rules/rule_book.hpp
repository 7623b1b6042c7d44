// The referee's rules by name, which a game file can switch on or off; the rule books, which
// contain rules and their parameters; and the rules that a team obeys.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/parameters.hpp"
#include "soccer/units.hpp"

namespace autoref {

// The rules, in the order in which the referee checks them.
enum class RuleId : std::uint8_t {
#define AUTOREF_RULE(id, ...) id,
#include "soccer/rules/rules.def"
#undef AUTOREF_RULE
};

#define AUTOREF_RULE(...) +1  // NOLINT(bugprone-macro-parentheses): a sum
inline constexpr int kRuleCount = 0
#include "soccer/rules/rules.def"
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

// The rules in force and their parameters, each with its source.

// Which edition a rule book follows. The divisions of an edition differ only in their values.
enum class Edition : std::uint8_t { kPaper, kLaws2014, kRules2026 };

// The rules of an edition, from rules.def. For the paper, these are the rules that it describes
// (section 4.2) and those that games need in order to end.
RuleSet rules_of(Edition edition);

// The rules in force and their values. The defaults are those of the paper.
struct RuleBook {
  std::string name = "paper";
  Edition edition = Edition::kPaper;
  RuleSet in_force = rules_of(Edition::kPaper);

  // The values in rule_numbers.def, each with its default.
#define AUTOREF_NUMBER(type, name, value, ...) type name = value;
#include "soccer/rules/rule_numbers.def"
#undef AUTOREF_NUMBER

  template <typename Self, typename Visitor>
  static void visit(Self& self, const Visitor& visitor) {
#define AUTOREF_NUMBER(type, name, value, range, about, source) \
  visitor(self.name, {#name, range, about, source});
#include "soccer/rules/rule_numbers.def"
#undef AUTOREF_NUMBER
  }

  bool has(RuleId rule) const { return in_force.has(rule); }
  bool operator==(const RuleBook&) const = default;
};

// The default settings for games under a rule book.
struct GameSetup {
  Field field;
  int robots = 6;  // robots per team
  double half_s = 600;
  // The preset for kickers and dribblers (sim/presets.hpp).
  std::string kickers_and_dribblers = "default";
  double latency_error_s = 0;  // sim/sim_configuration.hpp
};

// The rule book of that name; nullopt if the name is unknown.
std::optional<RuleBook> find_rule_book(std::string_view name);
std::vector<std::string> rule_book_names();

// The setup for the rule book of that name; nullopt if the name is unknown.
std::optional<GameSetup> find_game_setup(std::string_view name);

// One row of rules.def: a rule in one sentence, its section in each edition, and its threshold.
struct RuleEntry {
  RuleId rule{};
  std::string_view name{};   // in snake_case
  std::string_view about{};  // what it forbids or grants
  // Its section in each edition, for example "Laws 12"; empty if the edition does not have the
  // rule.
  std::string_view paper{};
  std::string_view laws_2014{};
  std::string_view rules_2026{};
  // The threshold; nullptr for rules that do not have exactly one.
  double RuleBook::*threshold = nullptr;
  // Whether a team's robots can obey or break the rule by what they do. The other rules say how a
  // game proceeds: what scores, which restart follows, and when the game ends.
  bool of_conduct = false;
  // Whether the rule also applies in a shoot-out. This is so for rules on fouls, on robots during a
  // stop, and on penalty kicks, but not for rules that lead to a restart other than a penalty kick.
  bool in_shootout = false;

  // Its section in the given edition.
  std::string_view section(Edition edition) const;
  // The threshold's unit; empty if the rule has no threshold.
  std::string_view unit() const;
};

// All rules, in the order of RuleId.
std::span<const RuleEntry> rule_table();
const RuleEntry& entry_of(RuleId rule);

// The rule's section in the book's own edition, or "AutoRef" if the rule was switched on although
// the edition does not have it.
std::string_view section_of(const RuleBook& rules, RuleId rule);

// The rules that a team obeys: those of `match`, plus any rules of conduct in `laws` (the rules
// that its members know) that the match does not enforce. The thresholds of the latter come from
// `laws`, unless the match enforces another rule with the same threshold. Everything else comes
// from the match: the edition, restarts, penalty kicks and cards.
RuleBook obeyed_rules(const RuleBook& match, const RuleBook& laws);

}  // namespace autoref
