// A rule book as numbers with names, for programs that do not know this project's rules.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "soccer/rule_book.hpp"

namespace autoref::league {

// Calls `visit` with the name and value of every number of the rule book, in a fixed order. Names
// are RuleBook's members; yes or no is 1 or 0. Then "edition" (0 paper, 1 Laws of 2014, 2 rules of
// 2026), and for each rule "in_force." and its name, 1 or 0.
void visit_rule_numbers(const RuleBook& rules,
                        const std::function<void(std::string_view name, double value)>& visit);

// Sets the number of that name, as visit_rule_numbers() names it, in a team's program; returns
// false if the name is unknown.
bool set_rule_number(RuleBook& rules, std::string_view name, double value);

}  // namespace autoref::league
