#include "app/referee/rules_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "io/json.hpp"
#include "soccer/rule_table.hpp"

namespace autoref::app {
namespace {

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
  std::string text = "Rule books (autoref rules NAME lists the rules in force):\n\n";
  for (const std::string& name : rule_book_names()) {
    const GameSetup setup = *find_game_setup(name);
    text += fmt::format("{:12} {:5} x {:4} m, {:2} robots per team, halves of {} s\n", name,
                        setup.field.length_m, setup.field.width_m, setup.robots, setup.half_s);
  }
  return text;
}

}  // namespace autoref::app
