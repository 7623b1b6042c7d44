#include "app/show/rules_verb.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "app/shared_options.hpp"
#include "app/verbs.hpp"
#include "io/errors.hpp"
#include "io/json.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"
#include "referee/machine/machine_figure.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::app {
namespace {

struct RulesArguments {
  std::string book;      // empty: list the rule books
  bool machine = false;  // print the state machine as a graph instead
  bool json = false;
};

std::string threshold_text(const RuleBook& rules, const RuleEntry& entry) {
  if (entry.threshold == nullptr) return "";
  return fmt::format("{:g} {}", rules.*entry.threshold, entry.unit());
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

int rules_verb(const RulesArguments& arguments) {
  if (arguments.machine) {
    if (!arguments.book.empty() || arguments.json)
      throw io::InputError({"--machine"}, "",
                           "prints a graph that all rule books share: leave out BOOK and --json");
    fmt::print("{}", referee::machine_graph());
    return io::kDone;
  }
  if (arguments.book.empty()) {
    fmt::print("{}", arguments.json ? books_json() : books_text());
    return io::kDone;
  }
  const std::optional<RuleBook> rules = find_rule_book(arguments.book);
  if (!rules) {
    const std::vector<std::string> known = rule_book_names();
    const std::string nearest = io::suggestion(arguments.book, known);
    throw io::InputError({}, "",
                         fmt::format("unknown rule book '{}'{} Known here: {}", arguments.book,
                                     nearest.empty() ? "." : nearest, io::listed(known)));
  }
  fmt::print("{}", arguments.json ? rules_json(*rules)
                                  : io::text_of(rules_text(*rules), io::text_width(stdout)));
  return io::kDone;
}

}  // namespace

io::TextBlocks rules_text(const RuleBook& rules) {
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
  return {fmt::format("Rules in force in '{}':\n\n", rules.name), std::move(table),
          fmt::format("\nNot in force (enable one with match.switch.NAME: true):\n{}\n",
                      fmt::join(others, ", "))};
}

std::string rules_json(const RuleBook& rules) {
  io::Json entries = io::Json::array();
  for (const RuleEntry& entry : rule_table()) entries.push_back(json_of(rules, entry));
  return io::json_text({{"name", rules.name}, {"rules", std::move(entries)}}) + "\n";
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
  add_json_flag(*verb, arguments->json);
  verb->add_flag("--machine", arguments->machine,
                 "Instead, print the referee's state machine as a graph for Graphviz's `dot`.");
  verb->footer(
      "Examples:\n  autoref show rules 2014\n"
      "  autoref show rules --machine | dot -Tsvg > machine.svg");
  choose(*verb, chosen, arguments, rules_verb);
}

}  // namespace autoref::app
