#include "soccer/rule_table.hpp"

#include <algorithm>
#include <array>

namespace autoref {
namespace {

// X macro: rules.def expands to one row per rule.
constexpr std::array<RuleEntry, kRuleCount> kTable = {{
#define AUTOREF_RULE(id, ...) {RuleId::id, __VA_ARGS__},
#include "soccer/parameters.hpp"
#include "soccer/rules.def"
#undef AUTOREF_RULE
}};

// The unit of each rule's threshold, from the threshold's name.
std::array<std::string_view, kRuleCount> threshold_units() {
  std::array<std::string_view, kRuleCount> units;
  const RuleBook book;
  for (const RuleEntry& entry : kTable) {
    if (entry.threshold == nullptr) continue;
    const void* const threshold = &(book.*entry.threshold);
    RuleBook::visit(book, [&](const auto& number, const Parameter& parameter) {
      if (&number == threshold)
        units[static_cast<std::size_t>(entry.rule)] = unit_of(parameter.name);
    });
  }
  return units;
}

}  // namespace

std::string_view RuleEntry::section(Edition edition) const {
  const std::array<std::string_view, 3> sections = {paper, laws_2014, rules_2026};
  return sections[static_cast<std::size_t>(edition)];
}

std::string_view RuleEntry::unit() const {
  static const std::array<std::string_view, kRuleCount> kUnits = threshold_units();
  return kUnits[static_cast<std::size_t>(rule)];
}

std::span<const RuleEntry> rule_table() { return kTable; }

const RuleEntry& entry_of(RuleId rule) { return kTable[static_cast<std::size_t>(rule)]; }

std::string_view section_of(const RuleBook& rules, RuleId rule) {
  const std::string_view section = entry_of(rule).section(rules.edition);
  return section.empty() ? "AutoRef" : section;
}

std::string_view name_of(RuleId rule) { return entry_of(rule).name; }

std::optional<RuleId> find_rule(std::string_view name) {
  const auto found = std::find_if(kTable.begin(), kTable.end(),
                                  [name](const RuleEntry& entry) { return entry.name == name; });
  return found == kTable.end() ? std::nullopt : std::optional(found->rule);
}

RuleSet rules_of(Edition edition) {
  RuleSet rules;
  for (const RuleEntry& entry : kTable) rules[entry.rule] = !entry.section(edition).empty();
  return rules;
}

}  // namespace autoref
