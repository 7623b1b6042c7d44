// A rule book as numbers with names, for programs that do not know this project's rules.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "league/team/team_messages.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::league {

// Calls `visit` with the name and value of every number of the rule book, in a fixed order. Names
// are RuleBook's members; yes or no is 1 or 0. Then "edition" (0 paper, 1 Laws of 2014, 2 rules of
// 2026), and for each rule "in_force." and its name, 1 or 0.
void visit_rule_numbers(const RuleBook& rules,
                        const std::function<void(std::string_view name, double value)>& visit);

// What a START contains: the numbers of the rule book, then what its record of the field has no
// room for: "field.goal_line_run_off_m", from the goal lines to the wall, and
// "field.goal_sides_reach_wall", 1 or 0. Last, for each rule, "obeyed." and its name, 1 or 0.
void visit_start_numbers(const TeamStart& start,
                         const std::function<void(std::string_view name, double value)>& visit);

}  // namespace autoref::league
