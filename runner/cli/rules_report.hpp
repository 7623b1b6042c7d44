// What a rule book has in force, for people and for scripts.
#pragma once

#include <string>

#include "soccer/rule_book.hpp"

namespace autoref::runner {

// A line for each rule in force: name, section, threshold, and what it says; then the rules that
// the book has not in force, which a game file may switch on.
std::string rules_text(const RuleBook& rules);

// The same as one JSON object.
std::string rules_json(const RuleBook& rules);

// The books that there are, a line for each, with their fields and robots.
std::string books_text();

}  // namespace autoref::runner
