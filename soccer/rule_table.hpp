// Every rule in one sentence, where each rule book has it, and its threshold: rules.def as a table.
#pragma once

#include <span>
#include <string_view>

#include "soccer/rule_book.hpp"
#include "soccer/rule_id.hpp"

namespace autoref {

struct RuleEntry {
  RuleId rule;
  std::string_view name;   // in snake_case
  std::string_view about;  // what it forbids or gives
  // Where an edition has it, such as "Laws 12"; empty where it does not.
  std::string_view paper;
  std::string_view laws_2014;
  std::string_view rules_2026;
  double RuleBook::*threshold = nullptr;  // none for rules without one number
  std::string_view unit;                  // of the threshold

  // The section of an edition.
  std::string_view section(Edition edition) const;
};

// In the order of RuleId.
std::span<const RuleEntry> rule_table();
const RuleEntry& entry_of(RuleId rule);

// Where the book has the rule: its own edition's section, or "ours" for a rule that was switched on
// in a book that has none.
std::string_view section_of(const RuleBook& rules, RuleId rule);

}  // namespace autoref
