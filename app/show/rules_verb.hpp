// The rules of a rule book, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "io/table.hpp"
#include "soccer/rules/rule_book.hpp"
#include "soccer/rules/rule_changes.hpp"

namespace autoref::app {

// One line per rule in force: name, section, threshold and description; then the rules not in
// force, which a game file can enable. `changes` are the differences from the official rules.
io::TextBlocks rules_text(const RuleBook& rules, const std::vector<RuleChange>& changes = {});

// One line per number: name, value with its unit, official value if it differs, and meaning.
io::TextBlocks numbers_text(const RuleBook& rules, const std::vector<RuleChange>& changes = {});

// The rules, their numbers and the changes as one JSON object.
std::string rules_json(const RuleBook& rules, const std::vector<RuleChange>& changes = {});

// One line per rule book, with its field and number of robots.
std::string books_text();

// The rule books as one JSON object.
std::string books_json();

}  // namespace autoref::app
