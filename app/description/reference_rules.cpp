// The reference page of rules: the rule books in which they are in force, their thresholds, numbers
// and sections, and the calls that they lead to.
#include <fmt/format.h>

#include <array>
#include <type_traits>

#include "app/description/reference_pages.hpp"
#include "referee/event.hpp"
#include "soccer/parameters.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::app {
namespace {

using referee::EventEntry;

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
  return fmt::format("{:g} {}", book.*entry.threshold, entry.unit());
}

std::string books_section() {
  Rows rows = table_with_books("rule");
  for (const RuleEntry& entry : rule_table()) {
    std::vector<std::string> row = {code_span(std::string(entry.name))};
    for (const RuleBook& book : rule_books()) row.push_back(in_book(book, entry));
    rows.push_back(std::move(row));
  }
  return "## In force\n\nThe rules in force in each rule book, with their thresholds, or \"yes\" "
         "for rules without one. `match.switch.NAME: true` or `false` changes that for a "
         "game.\n\n" +
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

// The value of a number in each rule book; yes is 1 and no is 0.
std::vector<std::string> numbers_called(std::string_view name) {
  std::vector<std::string> values;
  for (const RuleBook& book : rule_books()) {
    RuleBook::visit(book, [&](const auto& number, const Parameter& about) {
      if (about.name == name) values.push_back(fmt::format("{:g}", static_cast<double>(number)));
    });
  }
  return values;
}

// The values that a number can have: "above 0 and at most 5 m".
template <typename Number>
std::string allowed_text(const Number& /*any*/, const Parameter& about) {
  if constexpr (std::is_same_v<Number, bool>) return "true or false";
  return text_of(about.range, unit_of(about.name));
}

std::string numbers_section() {
  Rows rows = table_with_books("number");
  rows.front().insert(rows.front().end(), {"allowed", "meaning", "source"});
  const RuleBook any;
  RuleBook::visit(any, [&rows](const auto& number, const Parameter& about) {
    std::vector<std::string> row = {code_span(std::string(about.name))};
    for (std::string& value : numbers_called(about.name)) row.push_back(std::move(value));
    row.push_back(allowed_text(number, about));
    row.emplace_back(about.about);
    row.emplace_back(about.source);
    rows.push_back(std::move(row));
  });
  return "## Numbers\n\nThe numeric values in each rule book. `match.rule.NAME` changes a number "
         "for "
         "a game ([rule-laboratory.md](../rule-laboratory.md)), except that `extra_half_s` and "
         "`change_ends` are settings in `match`. Programs receive the numbers in the message START "
         "([team-programs.md](../team-programs.md)), which also has the edition and the rules in "
         "force. In this table and in START, 1 is true and 0 is false. The source says where the "
         "first rule book's value comes from, then what other texts say; \"2016\" is the authors' "
         "later public referee.\n\n" +
         reference_table(rows);
}

std::string effect_of(const EventEntry& entry) {
  using referee::Effect;
  using referee::When;
  constexpr std::array<std::string_view, 4> kEffects = {"", "stops play", "by the book", "counts"};
  constexpr std::array<std::string_view, 3> kWhen = {"", " in a stop", "; counts in a stop"};
  const std::string_view effect = kEffects[static_cast<std::size_t>(entry.effect)];
  if (entry.effect == Effect::kCounts && entry.when == When::kAnyTime) return "counts at any time";
  return fmt::format("{}{}", effect, kWhen[static_cast<std::size_t>(entry.when)]);
}

std::vector<std::string> row_of(const EventEntry& entry) {
  const bool has_card = entry.card != referee::Card::kNone;
  return {code_span(std::string(entry.name)),
          std::string(entry.about),
          std::string(entry.league_event),
          effect_of(entry),
          entry.is_foul ? "yes" : "",
          std::string(has_card ? name_of(entry.card) : ""),
          std::string(entry.restart ? name_of(*entry.restart) : "")};
}

std::string events_section() {
  Rows rows = {{"event", "meaning", "league event", "effect", "foul", "card", "restart"}};
  for (const EventEntry& entry : referee::event_table()) {
    if (referee::is_call(entry.event) || !entry.league_event.empty()) rows.push_back(row_of(entry));
  }
  return "## Events\n\nThe calls, which a game's row counts in the columns `calls_EVENT`, and the "
         "events about cards and ball placement. A call \"by the book\" stops play if fouls stop "
         "play under "
         "the rule book; otherwise the foul is counted and play continues. While play is stopped, "
         "calls only count as fouls, except where the "
         "[machine's tables](../../referee/README.md#the-machine) say more. Cards and restarts "
         "are listed if they are always the same. League events are those of the game controller "
         "(`GameEvent.Type`); event logs have both names.\n\n" +
         reference_table(rows);
}

}  // namespace

std::string rules_page() {
  std::string page = reference_head("Rules", "rules") +
                     "[rules.md](../rules.md) compares each rule with the league's text.\n\n" +
                     books_section() + sections_section() + events_section() + numbers_section();
  page.pop_back();
  return page;
}

}  // namespace autoref::app
