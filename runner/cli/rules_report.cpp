#include "runner/cli/rules_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "runner/io/json.hpp"
#include "soccer/rule_table.hpp"

namespace autoref::runner {
namespace {

std::string threshold_text(const RuleBook& rules, const RuleEntry& entry) {
  if (entry.threshold == nullptr) return "";
  return fmt::format("{:g} {}", rules.*entry.threshold, entry.unit);
}

// Column widths: the length of the longest text.
struct Widths {
  std::size_t name = 0;
  std::size_t section = 0;
};

Widths widths_of(const RuleBook& rules) {
  Widths widths;
  for (const RuleEntry& entry : rule_table()) {
    if (!rules.has(entry.rule)) continue;
    widths.name = std::max(widths.name, entry.name.size());
    widths.section = std::max(widths.section, section_of(rules, entry.rule).size());
  }
  return widths;
}

std::string json_of(const RuleBook& rules, const RuleEntry& entry) {
  const bool has_threshold = entry.threshold != nullptr;
  return JsonObject()
      .add("rule", json_text(entry.name))
      .add("in_force", rules.has(entry.rule) ? "true" : "false")
      .add("section", json_text(section_of(rules, entry.rule)))
      .add("threshold", has_threshold ? json_number(rules.*entry.threshold) : "null")
      .add("unit", has_threshold ? json_text(entry.unit) : "null")
      .add("about", json_text(entry.about))
      .text();
}

}  // namespace

std::string rules_text(const RuleBook& rules) {
  std::string text = fmt::format("Rules in force in '{}':\n\n", rules.name);
  std::vector<std::string_view> others;
  const Widths widths = widths_of(rules);
  for (const RuleEntry& entry : rule_table()) {
    if (!rules.has(entry.rule)) {
      others.push_back(entry.name);
      continue;
    }
    text += fmt::format("{:{}}  {:{}}  {:>8}  {}\n", entry.name, widths.name,
                        section_of(rules, entry.rule), widths.section, threshold_text(rules, entry),
                        entry.about);
  }
  return text + fmt::format("\nNot in force (enable one with match.switch.NAME: true):\n{}\n",
                            fmt::join(others, ", "));
}

std::string rules_json(const RuleBook& rules) {
  std::vector<std::string> entries;
  for (const RuleEntry& entry : rule_table()) entries.push_back(json_of(rules, entry));
  return JsonObject().add("name", json_text(rules.name)).add("rules", json_list(entries)).text() +
         "\n";
}

std::string books_text() {
  std::string text = "Rule books (autoref rules NAME lists the rules in force):\n\n";
  for (const std::string& name : rule_book_names()) {
    const GameSetup setup = *find_game_setup(name);
    text += fmt::format("{:12} {:5} x {:4} m, {:2} robots per team, halves of {} s\n", name,
                        setup.field.length_m, setup.field.width_m, setup.robots, setup.half_s);
  }
  return text;
}

}  // namespace autoref::runner
