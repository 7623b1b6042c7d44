#include "app/show/rules_verb.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "game/settings/assignments.hpp"
#include "game/settings/game_settings.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"
#include "referee/machine/machine_figure.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::app {
namespace {

struct RulesArguments {
  std::string book;  // empty: list the rule books
  std::vector<std::string> sets;
  bool numbers = false;  // print the numbers instead of the rules
  bool machine = false;  // print the state machine as a graph instead
  bool json = false;
};

std::string threshold_text(const RuleBook& rules, const RuleEntry& entry) {
  if (entry.threshold == nullptr) return "";
  return fmt::format("{:g} {}", rules.*entry.threshold, entry.unit());
}

// "0.05 m", "yes".
template <typename Number>
std::string value_text(const Number& number, const Parameter& about) {
  if constexpr (std::is_same_v<Number, bool>) return number ? "yes" : "no";
  const std::string_view unit = unit_of(about.name);
  return fmt::format("{:g}{}{}", static_cast<double>(number), unit.empty() ? "" : " ", unit);
}

io::Json json_of(const RuleBook& rules, const RuleEntry& entry) {
  const bool has_threshold = entry.threshold != nullptr;
  return {{"rule", entry.name},
          {"in_force", rules.has(entry.rule)},
          {"section", section_of(rules, entry.rule)},
          {"threshold", has_threshold ? io::Json(rules.*entry.threshold) : io::Json()},
          {"unit", has_threshold ? io::Json(entry.unit()) : io::Json()},
          {"about", entry.about}};
}

// A game under the rule book of that name.
game::GameSettings game_under(const std::string& book) {
  if (!find_rule_book(book)) {
    const std::vector<std::string> known = rule_book_names();
    const std::string nearest = io::suggestion(book, known);
    throw io::InputError({}, "",
                         fmt::format("unknown rule book '{}'{} Known here: {}", book,
                                     nearest.empty() ? "." : nearest, io::listed(known)));
  }
  game::GameSettings game;
  game::choose_rules(book, game);
  return game;
}

// The other settings do not change rules.
void refuse_others(const game::Assignments& assignments) {
  for (const game::Assignment& assignment : assignments) {
    const std::string& path = assignment.path;
    if (path == kRuleBookPath)
      throw io::InputError({assignment.flag}, "", "give the rule book as the argument BOOK");
    if (path.starts_with("match.") || path.starts_with("field.")) continue;
    throw io::InputError(
        {assignment.flag}, "",
        "does not change the rules; give a setting that starts with match. or field.");
  }
}

int print_machine(const RulesArguments& arguments) {
  if (!arguments.book.empty() || arguments.json || arguments.numbers || !arguments.sets.empty())
    throw io::InputError({"--machine"}, "",
                         "prints a graph that all rule books share: leave out BOOK and the other "
                         "options");
  fmt::print("{}", referee::machine_graph());
  return io::kDone;
}

int print_books(const RulesArguments& arguments) {
  if (arguments.numbers || !arguments.sets.empty())
    throw io::InputError({arguments.numbers ? "--numbers" : "--set"}, "",
                         "needs a rule book, for example: autoref show rules 2014 --numbers");
  fmt::print("{}", arguments.json ? books_json() : books_text());
  return io::kDone;
}

int rules_verb(const RulesArguments& arguments) {
  if (arguments.machine) return print_machine(arguments);
  if (arguments.book.empty()) return print_books(arguments);
  game::GameSettings game = game_under(arguments.book);
  const game::Assignments assignments = game::assignments_in(arguments.sets);
  refuse_others(assignments);
  game::assign_all(assignments, game);
  const RuleBook& rules = game.match.rules;
  const std::vector<RuleChange> changes = rule_changes(rules, game.field);
  if (arguments.json) {
    fmt::print("{}", rules_json(rules, changes));
  } else {
    fmt::print("{}", io::text_of(arguments.numbers ? numbers_text(rules, changes)
                                                   : rules_text(rules, changes),
                                 io::text_width(stdout)));
  }
  return io::kDone;
}

}  // namespace

io::TextBlocks rules_text(const RuleBook& rules, const std::vector<RuleChange>& changes) {
  std::vector<std::string_view> others;
  io::TextTable table{{},
                      {io::Align::kLeft, io::Align::kLeft, io::Align::kRight, io::Align::kLeft}};
  for (const RuleEntry& entry : rule_table()) {
    if (rules.has(entry.rule)) {
      table.rows.push_back({std::string(entry.name), std::string(section_of(rules, entry.rule)),
                            threshold_text(rules, entry), std::string(entry.about)});
    } else {
      others.push_back(entry.name);
    }
  }
  return {fmt::format("Rules in force in {}:\n\n", name_with_changes(rules.name, text_of(changes))),
          std::move(table),
          fmt::format("\nNot in force (enable one with match.switch.NAME: true):\n{}\n",
                      fmt::join(others, ", "))};
}

io::TextBlocks numbers_text(const RuleBook& rules, const std::vector<RuleChange>& changes) {
  io::TextTable table{{},
                      {io::Align::kLeft, io::Align::kRight, io::Align::kLeft, io::Align::kLeft}};
  const std::optional<RuleBook> official = find_rule_book(rules.name);
  RuleBook::visit(rules, [&](const auto& number, const Parameter& about) {
    const std::string value = value_text(number, about);
    std::string official_value;
    RuleBook::visit(*official, [&](const auto& other, const Parameter& its_about) {
      if (its_about.name == about.name) official_value = value_text(other, about);
    });
    table.rows.push_back(
        {path_of_number(about.name), value,
         official_value == value ? "" : fmt::format("officially {}", official_value),
         std::string(about.about)});
  });
  return {fmt::format("Numbers of {}:\n\n", name_with_changes(rules.name, text_of(changes))),
          std::move(table)};
}

std::string rules_json(const RuleBook& rules, const std::vector<RuleChange>& changes) {
  io::Json entries = io::Json::array();
  for (const RuleEntry& entry : rule_table()) entries.push_back(json_of(rules, entry));
  io::Json numbers;
  RuleBook::visit(rules, [&numbers](const auto& number, const Parameter& about) {
    numbers[std::string(about.name)] = number;
  });
  io::Json changed = io::Json::array();
  for (const RuleChange& change : changes)
    changed.push_back({{"setting", change.path}, {"text", change.text}});
  return io::json_text({{"name", rules.name},
                        {"rules", std::move(entries)},
                        {"numbers", std::move(numbers)},
                        {"changes", std::move(changed)}}) +
         "\n";
}

std::string books_text() {
  std::string text = "Rule books (autoref show rules NAME lists the rules in force):\n\n";
  for (const std::string& name : rule_book_names()) {
    const GameSetup setup = *find_game_setup(name);
    text += fmt::format("{:12} {:5} x {:4} m, {:2} robots per team, halves of {} s\n", name,
                        setup.field.length_m, setup.field.width_m, setup.robots, setup.half_s);
  }
  return text;
}

std::string books_json() {
  io::Json books = io::Json::array();
  for (const std::string& name : rule_book_names()) {
    const GameSetup setup = *find_game_setup(name);
    books.push_back({{"name", name},
                     {"field_length_m", setup.field.length_m},
                     {"field_width_m", setup.field.width_m},
                     {"robots", setup.robots},
                     {"half_s", setup.half_s}});
  }
  return io::json_text({{"rule_books", std::move(books)}}) + "\n";
}

void add_rules_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("rules", "List the rule books, or the rules of one.");
  auto arguments = std::make_shared<RulesArguments>();
  verb->add_option("BOOK", arguments->book, "Name of a rule book. Default: list all rule books.");
  add_set_option(*verb, arguments->sets,
                 "Change a setting in match or field, such as match.rule.dribbling_m=2. May be "
                 "repeated.");
  verb->add_flag("--numbers", arguments->numbers,
                 "List the numbers instead of the rules, each with its setting.");
  add_json_flag(*verb, arguments->json);
  verb->add_flag("--machine", arguments->machine,
                 "Instead, print the referee's state machine as a graph for Graphviz's `dot`.");
  verb->footer(
      "Examples:\n  autoref show rules 2014\n"
      "  autoref show rules 2026-b --set match.rule.double_touch_m=0.15\n"
      "  autoref show rules --machine | dot -Tsvg > machine.svg");
  choose(*verb, chosen, arguments, rules_verb);
}

}  // namespace autoref::app
