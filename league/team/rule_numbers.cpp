#include "league/team/rule_numbers.hpp"

#include <array>
#include <variant>

#include "soccer/rule_table.hpp"

namespace autoref::league {
namespace {

struct RuleNumber {
  std::string_view name;
  std::variant<double RuleBook::*, int RuleBook::*, bool RuleBook::*> member;
};

#define AUTOREF_NUMBER(name) \
  RuleNumber { #name, &RuleBook::name }
constexpr std::array kNumbers = {
    AUTOREF_NUMBER(stillness_m),
    AUTOREF_NUMBER(readiness_period_s),
    AUTOREF_NUMBER(ready_timeout_s),
    AUTOREF_NUMBER(start_timeout_s),
    AUTOREF_NUMBER(ball_at_rest_mps),
    AUTOREF_NUMBER(ball_in_position_m),
    AUTOREF_NUMBER(throw_in_inset_m),
    AUTOREF_NUMBER(corner_inset_m),
    AUTOREF_NUMBER(goal_kick_touch_inset_m),
    AUTOREF_NUMBER(goal_kick_goal_inset_m),
    AUTOREF_NUMBER(kicks_may_score),
    AUTOREF_NUMBER(in_play_m),
    AUTOREF_NUMBER(restart_timeout_s),
    AUTOREF_NUMBER(free_kick_timeout_s),
    AUTOREF_NUMBER(untaken_goes_to_opponents),
    AUTOREF_NUMBER(opponents_to_ball_m),
    AUTOREF_NUMBER(attacker_to_area_m),
    AUTOREF_NUMBER(attacker_grace_s),
    AUTOREF_NUMBER(own_area_kick_goal_inset_m),
    AUTOREF_NUMBER(own_area_kick_touch_inset_m),
    AUTOREF_NUMBER(free_kick_to_area_m),
    AUTOREF_NUMBER(stuck_time_s),
    AUTOREF_NUMBER(stuck_distance_m),
    AUTOREF_NUMBER(neutral_to_area_m),
    AUTOREF_NUMBER(kick_limit_mps),
    AUTOREF_NUMBER(chip_height_m),
    AUTOREF_NUMBER(dribbling_m),
    AUTOREF_NUMBER(keeper_holding_s),
    AUTOREF_NUMBER(goal_after_foul_s),
    AUTOREF_NUMBER(pushing_m),
    AUTOREF_NUMBER(crash_mps),
    AUTOREF_NUMBER(crash_drawn_mps),
    AUTOREF_NUMBER(stop_speed_mps),
    AUTOREF_NUMBER(stop_grace_s),
    AUTOREF_NUMBER(placement_clearance_m),
    AUTOREF_NUMBER(placement_grace_s),
    AUTOREF_NUMBER(fouls_stop_play),
    AUTOREF_NUMBER(foul_repeat_s),
    AUTOREF_NUMBER(interference_s),
    AUTOREF_NUMBER(placement_time_s),
    AUTOREF_NUMBER(placement_least_s),
    AUTOREF_NUMBER(placement_tolerance_m),
    AUTOREF_NUMBER(placement_robots_m),
    AUTOREF_NUMBER(placement_robots_force_m),
    AUTOREF_NUMBER(placement_not_needed_m),
    AUTOREF_NUMBER(placement_to_area_m),
    AUTOREF_NUMBER(placement_failures),
    AUTOREF_NUMBER(penalty_clearance_m),
    AUTOREF_NUMBER(penalty_time_s),
    AUTOREF_NUMBER(penalty_turn_deg),
    AUTOREF_NUMBER(penalty_fouls_decide),
    AUTOREF_NUMBER(penalty_prolongs_half),
    AUTOREF_NUMBER(card_s),
    AUTOREF_NUMBER(fouls_per_card),
    AUTOREF_NUMBER(yellows_per_red),
    AUTOREF_NUMBER(too_many_s),
    AUTOREF_NUMBER(timeouts),
    AUTOREF_NUMBER(timeouts_s),
    AUTOREF_NUMBER(extra_timeouts),
    AUTOREF_NUMBER(extra_timeouts_s),
    AUTOREF_NUMBER(goals_to_win),
    AUTOREF_NUMBER(goal_lead),
    AUTOREF_NUMBER(clock_stops),
    AUTOREF_NUMBER(change_ends),
    AUTOREF_NUMBER(extra_half_s),
    AUTOREF_NUMBER(shootout_kicks),
};
#undef AUTOREF_NUMBER

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
  for (const RuleNumber& number : kNumbers) {
    if (number.name != name) continue;
    std::visit(
        [&](auto member) {
          using Value = std::remove_reference_t<decltype(rules.*member)>;
          rules.*member = static_cast<Value>(value);
        },
        number.member);
    return true;
  }
  return false;
}

}  // namespace

void visit_rule_numbers(const RuleBook& rules,
                        const std::function<void(std::string_view name, double value)>& visit) {
  for (const RuleNumber& number : kNumbers) {
    std::visit([&](auto member) { visit(number.name, static_cast<double>(rules.*member)); },
               number.member);
  }
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
