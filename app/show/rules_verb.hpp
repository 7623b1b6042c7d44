// The rules of a rule book, as text and as JSON.
#pragma once

#include <string>

#include "io/table.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::app {

// One line per rule in force: name, section, threshold and description; then the rules not in
// force, which a game file can enable.
io::TextBlocks rules_text(const RuleBook& rules);

// The rules as one JSON object.
std::string rules_json(const RuleBook& rules);

// One line per rule book, with its field and number of robots.
std::string books_text();

// The rule books as one JSON object.
std::string books_json();

}  // namespace autoref::app
