// Every rule in one sentence, its section in each edition, and its threshold: rules.def as a table.
#pragma once

#include <span>
#include <string_view>

#include "soccer/rule_book.hpp"
#include "soccer/rule_id.hpp"

namespace autoref {

struct RuleEntry {
  RuleId rule;
  std::string_view name;   // in snake_case
  std::string_view about;  // what it forbids or grants
  // Its section in each edition, for example "Laws 12"; empty if the edition lacks the rule.
  std::string_view paper;
  std::string_view laws_2014;
  std::string_view rules_2026;
  double RuleBook::*threshold = nullptr;  // nullptr for rules without a single number

  // Its section in the given edition.
  std::string_view section(Edition edition) const;
  // The threshold's unit; empty without a threshold.
  std::string_view unit() const;
};

// All rules, in the order of RuleId.
std::span<const RuleEntry> rule_table();
const RuleEntry& entry_of(RuleId rule);

// The rule's section in the book's own edition, or "AutoRef" if the rule was switched on although
// the edition lacks it.
std::string_view section_of(const RuleBook& rules, RuleId rule);

}  // namespace autoref
