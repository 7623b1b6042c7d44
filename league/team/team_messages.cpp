#include "league/team/team_messages.hpp"

#include "soccer/rules/rule_book.hpp"

namespace autoref::league {
namespace {

void visit_rules(std::string_view prefix, const RuleSet& rules,
                 const std::function<void(std::string_view name, double value)>& visit) {
  for (const RuleEntry& entry : rule_table())
    visit(std::string(prefix) + std::string(entry.name), rules.has(entry.rule) ? 1 : 0);
}

}  // namespace

void visit_rule_numbers(const RuleBook& rules,
                        const std::function<void(std::string_view name, double value)>& visit) {
  RuleBook::visit(rules, [&visit](const auto& number, const Parameter& about) {
    visit(about.name, static_cast<double>(number));
  });
  visit("edition", static_cast<double>(rules.edition));
  visit_rules("in_force.", rules.in_force, visit);
}

void visit_start_numbers(const TeamStart& start,
                         const std::function<void(std::string_view name, double value)>& visit) {
  visit_rule_numbers(start.rules, visit);
  visit("field.goal_line_run_off_m", start.field.behind_goal_lines_m());
  visit("field.goal_sides_reach_wall", start.field.goal_sides_reach_wall ? 1 : 0);
  visit_rules("obeyed.", start.obeyed, visit);
}

}  // namespace autoref::league
