// Reads the numbers of a START message, as a team's program does.
#pragma once

#include <string_view>
#include <type_traits>

#include "league/team/team_messages.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::league {

// Switches the rule that is called `name` without the `prefix`; returns false if there is none.
inline bool set_rule(RuleSet& rules, std::string_view prefix, std::string_view name, double value) {
  if (!name.starts_with(prefix)) return false;
  const std::optional<RuleId> rule = find_rule(name.substr(prefix.size()));
  if (rule) rules[*rule] = value != 0;
  return rule.has_value();
}

inline bool set_rule_number(RuleBook& rules, std::string_view name, double value) {
  bool is_known = false;
  RuleBook::visit(rules, [&](auto& number, const Parameter& about) {
    if (about.name != name) return;
    number = static_cast<std::remove_reference_t<decltype(number)>>(value);
    is_known = true;
  });
  return is_known;
}

// Sets the number that visit_start_numbers() calls by that name; returns false if the name is
// unknown.
inline bool set_start_number(TeamStart& start, std::string_view name, double value) {
  if (name == "field.goal_line_run_off_m") {
    start.field.goal_line_run_off_m = value;
    return true;
  }
  if (name == "field.goal_sides_reach_wall") {
    start.field.goal_sides_reach_wall = value != 0;
    return true;
  }
  if (name == "edition") {
    start.rules.edition = static_cast<Edition>(value);
    return true;
  }
  return set_rule_number(start.rules, name, value) ||
         set_rule(start.rules.in_force, "in_force.", name, value) ||
         set_rule(start.obeyed, "obeyed.", name, value);
}

}  // namespace autoref::league
