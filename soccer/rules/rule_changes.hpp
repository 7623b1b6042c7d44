// How a game's rules differ from the official ones: the rule book of the same name, and its field.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/field.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref {

// One number of a rule book or measure of the field, or one rule that was switched on or off.
struct RuleChange {
  std::string path;  // its setting: "match.rule.double_touch_m", "field.goal_width_m"
  std::string text;  // the value, and the official one in brackets: "double touch 150 mm (50)"
};

// The setting that chooses the rule book.
inline constexpr const char* kRuleBookPath = "match.rules";

// The branches of settings with the numbers of a rule book, and with its rules.
inline constexpr std::string_view kRuleNumberBranch = "match.rule.";
inline constexpr std::string_view kRuleSwitchBranch = "match.switch.";

// The numbers that are settings of the match itself, such as "match.extra_half_s", in the order of
// the settings.
inline constexpr std::array<std::string_view, 2> kNumbersOfMatch = {"extra_half_s", "change_ends"};

// The setting for a number of a rule book: "match.rule.double_touch_m", or below "match." for one
// of kNumbersOfMatch.
std::string path_of_number(std::string_view name);

// All changes, in the order of the settings: numbers, switches, field. Empty for a book without an
// official one.
std::vector<RuleChange> rule_changes(const RuleBook& rules, const Field& field);

// The texts of all changes: "double touch 150 mm (50); offside yes (no)".
std::string text_of(const std::vector<RuleChange>& changes);

// "not the official rules: double touch 150 mm (50)", for a text_of() changes; empty for an empty
// list.
std::string not_official_text(const std::string& list);

// The book's name, and its changes if there are any: "2026-b, not the official rules: double touch
// 150 mm (50)".
std::string name_with_changes(const std::string& book, const std::string& list);

// Throws OutOfRange if a changed number contradicts another one or leaves no room on the field. The
// error's path is the number's name, without the branch. Official numbers are valid on any field.
void check_rules(const RuleBook& rules, const Field& field);

}  // namespace autoref
