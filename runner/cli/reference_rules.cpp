// The reference page of rules: which rule books have them in force, thresholds, numbers, sections.
#include <fmt/format.h>

#include <map>

#include "league/team/rule_numbers.hpp"
#include "runner/cli/reference_pages.hpp"
#include "soccer/rule_book.hpp"
#include "soccer/rule_table.hpp"

namespace autoref::runner {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::vector<RuleBook> rule_books() {
  std::vector<RuleBook> books;
  for (const std::string& name : rule_book_names()) books.push_back(*find_rule_book(name));
  return books;
}

Rows table_with_books(const std::string& first) {
  Rows rows = {{first}};
  for (const std::string& name : rule_book_names()) rows.front().push_back(code_span(name));
  return rows;
}

std::string in_book(const RuleBook& book, const RuleEntry& entry) {
  if (!book.has(entry.rule)) return "–";
  if (entry.threshold == nullptr) return "yes";
  return fmt::format("{:g} {}", book.*entry.threshold, entry.unit);
}

std::string books_section() {
  Rows rows = table_with_books("rule");
  for (const RuleEntry& entry : rule_table()) {
    std::vector<std::string> row = {code_span(std::string(entry.name))};
    for (const RuleBook& book : rule_books()) row.push_back(in_book(book, entry));
    rows.push_back(std::move(row));
  }
  return "## In force\n\nA rule's threshold, or \"yes\" if it has none, where the rule book has it "
         "in force. `match.switch.NAME: true` or `false` changes that for a game.\n\n" +
         reference_table(rows);
}

std::string sections_section() {
  Rows rows = {{"rule", "meaning", "paper", "Laws of 2014", "rules of 2026"}};
  for (const RuleEntry& entry : rule_table()) {
    rows.push_back({code_span(std::string(entry.name)), std::string(entry.about),
                    std::string(entry.paper), std::string(entry.laws_2014),
                    std::string(entry.rules_2026)});
  }
  return "## Meanings and sections\n\n" + reference_table(rows);
}

// Names of a rule book's numbers in their order, without those that the other tables show.
std::vector<std::string> number_names() {
  std::vector<std::string> names;
  league::visit_rule_numbers(RuleBook{}, [&names](std::string_view name, double) {
    if (!name.starts_with("in_force.")) names.emplace_back(name);
  });
  return names;
}

std::string numbers_section() {
  std::vector<std::map<std::string, double, std::less<>>> values;
  for (const RuleBook& book : rule_books()) {
    values.emplace_back();
    league::visit_rule_numbers(book, [&values](std::string_view name, double value) {
      values.back()[std::string(name)] = value;
    });
  }
  Rows rows = table_with_books("number");
  for (const std::string& name : number_names()) {
    std::vector<std::string> row = {code_span(name)};
    for (auto& of_book : values) row.push_back(fmt::format("{:g}", of_book[name]));
    rows.push_back(std::move(row));
  }
  return "## Numbers\n\nThe numbers of each rule book, as programs receive them in the message "
         "START ([team-programs.md](../team-programs.md)); 1 is yes, 0 is no. Their meanings are "
         "in "
         "[rule_book.hpp](../../soccer/rule_book.hpp).\n\n" +
         reference_table(rows);
}

}  // namespace

std::string rules_page() {
  std::string page = reference_head("Rules", "rules") +
                     "Calls and the league's events are listed in "
                     "[referee/README.md](../../referee/README.md#events"
                     "); [rules.md](../rules.md) compares each rule with the league's text.\n\n" +
                     books_section() + sections_section() + numbers_section();
  page.pop_back();
  return page;
}

}  // namespace autoref::runner
