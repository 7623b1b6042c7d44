#include "league/team/rule_numbers.hpp"

#include <type_traits>

#include "soccer/rule_table.hpp"

namespace autoref::league {
namespace {

constexpr std::string_view kEdition = "edition";
constexpr std::string_view kInForce = "in_force.";
constexpr std::string_view kGoalLineRunOff = "field.goal_line_run_off_m";
constexpr std::string_view kGoalSidesReachWall = "field.goal_sides_reach_wall";
constexpr std::string_view kObeyed = "obeyed.";

void visit_rules(std::string_view prefix, const RuleSet& rules,
                 const std::function<void(std::string_view name, double value)>& visit) {
  for (const RuleEntry& entry : rule_table())
    visit(std::string(prefix) + std::string(entry.name), rules.has(entry.rule) ? 1 : 0);
}

// Switches the rule whose name, after `prefix`, is `name`; returns false if that is not one.
bool set_rule(RuleSet& rules, std::string_view prefix, std::string_view name, double value) {
  if (!name.starts_with(prefix)) return false;
  const std::optional<RuleId> rule = find_rule(name.substr(prefix.size()));
  if (rule) rules[*rule] = value != 0;
  return rule.has_value();
}

bool set_rule_number(RuleBook& rules, std::string_view name, double value) {
  bool is_known = false;
  RuleBook::visit(rules, [&](auto& number, const Parameter& about) {
    if (about.name != name) return;
    number = static_cast<std::remove_reference_t<decltype(number)>>(value);
    is_known = true;
  });
  return is_known;
}

}  // namespace

void visit_rule_numbers(const RuleBook& rules,
                        const std::function<void(std::string_view name, double value)>& visit) {
  RuleBook::visit(rules, [&visit](const auto& number, const Parameter& about) {
    visit(about.name, static_cast<double>(number));
  });
  visit(kEdition, static_cast<double>(rules.edition));
  visit_rules(kInForce, rules.in_force, visit);
}

void visit_start_numbers(const TeamStart& start,
                         const std::function<void(std::string_view name, double value)>& visit) {
  visit_rule_numbers(start.rules, visit);
  visit(kGoalLineRunOff, start.field.behind_goal_lines_m());
  visit(kGoalSidesReachWall, start.field.goal_sides_reach_wall ? 1 : 0);
  visit_rules(kObeyed, start.obeyed, visit);
}

bool set_start_number(TeamStart& start, std::string_view name, double value) {
  if (name == kGoalLineRunOff) {
    start.field.goal_line_run_off_m = value;
    return true;
  }
  if (name == kGoalSidesReachWall) {
    start.field.goal_sides_reach_wall = value != 0;
    return true;
  }
  if (name == kEdition) {
    start.rules.edition = static_cast<Edition>(value);
    return true;
  }
  return set_rule_number(start.rules, name, value) ||
         set_rule(start.rules.in_force, kInForce, name, value) ||
         set_rule(start.obeyed, kObeyed, name, value);
}

}  // namespace autoref::league
