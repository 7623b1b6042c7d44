#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "app/command_line.hpp"
#include "app/referee/rules_report.hpp"
#include "io/errors.hpp"
#include "io/terminal.hpp"
#include "io/words.hpp"
#include "referee/machine/machine_graph.hpp"
#include "soccer/rule_book.hpp"

namespace autoref::app {

int rules_verb(const RulesArguments& arguments) {
  if (arguments.machine) {
    fmt::print("{}", referee::machine_graph());
    return io::kDone;
  }
  if (arguments.book.empty()) {
    fmt::print("{}", books_text());
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

void add_rules_verb(CLI::App& app, Chosen& chosen) {
  CLI::App* verb = app.add_subcommand("rules", "List the rule books, or the rules of one.");
  auto arguments = std::make_shared<RulesArguments>();
  verb->add_option("BOOK", arguments->book, "Name of a rule book. Default: list all rule books.");
  verb->add_flag("--json", arguments->json, "Print one JSON object.");
  verb->add_flag("--machine", arguments->machine,
                 "Instead, print the referee's state machine as a graph for Graphviz's `dot`.");
  for (const char* other : {"BOOK", "--json"})
    verb->get_option("--machine")->excludes(verb->get_option(other));
  verb->footer(
      "Examples:\n  autoref rules 2014\n"
      "  autoref rules --machine | dot -Tsvg > machine.svg");
  verb->callback([arguments, &chosen] { chosen = [arguments] { return rules_verb(*arguments); }; });
}

}  // namespace autoref::app
