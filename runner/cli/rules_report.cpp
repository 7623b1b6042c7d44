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

std::size_t longest_section(const RuleBook& rules) {
  std::size_t longest = 0;
  for (const RuleEntry& entry : rule_table()) {
    if (rules.has(entry.rule)) longest = std::max(longest, section_of(rules, entry.rule).size());
  }
  return longest;
}

std::string json_of(const RuleBook& rules, const RuleEntry& entry) {
  const bool has_threshold = entry.threshold != nullptr;
  return JsonObject()
      .add("rule", json_text(name_of(entry.rule)))
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
  const std::size_t width = longest_section(rules);
  for (const RuleEntry& entry : rule_table()) {
    if (!rules.has(entry.rule)) {
      others.push_back(name_of(entry.rule));
      continue;
    }
    text +=
        fmt::format("{:22} {:{}}  {:>8}  {}\n", name_of(entry.rule), section_of(rules, entry.rule),
                    width, threshold_text(rules, entry), entry.about);
  }
  return text + fmt::format("\nNot in force (match.switch.NAME: true puts one in force):\n{}\n",
                            fmt::join(others, ", "));
}

std::string rules_json(const RuleBook& rules) {
  std::vector<std::string> entries;
  for (const RuleEntry& entry : rule_table()) entries.push_back(json_of(rules, entry));
  return JsonObject().add("name", json_text(rules.name)).add("rules", json_list(entries)).text() +
         "\n";
}

std::string books_text() {
  std::string text = "Rule books (autoref rules NAME says what is in force):\n\n";
  for (const std::string& name : rule_book_names()) {
    const GameSetup setup = *find_game_setup(name);
    text += fmt::format("{:12} {:5} x {:4} m, {:2} robots a team, halves of {} s\n", name,
                        setup.field.length_m, setup.field.width_m, setup.robots, setup.half_s);
  }
  return text;
}

}  // namespace autoref::runner
