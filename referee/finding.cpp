#include "referee/finding.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "referee/geometry/restarts.hpp"
#include "soccer/rules/rule_book.hpp"

namespace autoref::referee {

Finding finding_of(Event event, RuleId rule, const RuleBook& rules) {
  const RuleEntry& entry = entry_of(rule);
  Finding finding;
  finding.event = event;
  finding.card = entry_of(event).card;
  finding.is_foul = entry_of(event).counts_to_card && rules.fouls_per_card > 0;
  finding.restart.kind = entry_of(event).restart.value_or(finding.restart.kind);
  finding.rule = section_of(rules, rule);
  if (entry.threshold != nullptr) finding.threshold = rules.*entry.threshold;
  finding.unit = entry.unit();
  return finding;
}

Finding offence_of(Event event, RuleId rule, const Configuration& configuration, RobotId robot,
                   const Vec2& where_m) {
  Finding finding = offence_of(event, rule, configuration, robot.side, where_m);
  finding.robots.push_back(robot);
  return finding;
}

Finding offence_of(Event event, RuleId rule, const Configuration& configuration, Side offender,
                   const Vec2& where_m) {
  const RuleBook& rules = configuration.rules;
  const Side kicker = opponent_of(offender);
  Finding finding = finding_of(event, rule, rules);
  finding.offender = offender;
  finding.position_m = where_m;
  finding.restart = indirect_free_kick(rules, kicker);
  finding.restart.kind = entry_of(event).restart.value_or(finding.restart.kind);
  finding.ball_to_m = free_kick_position(configuration.field, rules, kicker, where_m);
  return finding;
}

Finding note_of(Event event, RuleId rule, const RuleBook& rules, RobotId robot,
                const Vec2& where_m) {
  Finding finding = finding_of(event, rule, rules);
  finding.robots.push_back(robot);
  finding.offender = robot.side;
  finding.position_m = where_m;
  return finding;
}

Finding contact_foul_of(Event event, RuleId rule, const Configuration& configuration, RobotId robot,
                        const Vec2& robot_m, const Vec2& where_m) {
  const Field& field = configuration.field;
  Finding finding = offence_of(event, rule, configuration, robot, where_m);
  finding.restart.kind = CommandKind::kDirectFree;
  if (configuration.rules.edition != Edition::kRules2026 &&
      distance_to_defence_area(field, robot.side, robot_m) <= 0) {
    finding.restart.kind = CommandKind::kPreparePenalty;
    finding.ball_to_m = field.penalty_mark_at(robot.side);
  }
  return finding;
}

Command indirect_free_kick(const RuleBook& rules, Side kicker) {
  return {rules.kicks_may_score ? CommandKind::kDirectFree : CommandKind::kIndirectFree, kicker};
}

std::string text_of(RobotId robot) {
  return fmt::format("{} {}", colour_of(robot.side), robot.number);
}

std::string mm_text(double distance_m) {
  return fmt::format("{:.0f} mm", std::max(0.0, 1e3 * distance_m));
}

std::string gap_text(double signed_distance_m) {
  const char* where = signed_distance_m < 0 ? "inside" : "from";
  return fmt::format("{} {}", mm_text(std::abs(signed_distance_m)), where);
}

std::string ordinal(int number) {
  constexpr std::array kEndings = {"th", "st", "nd", "rd"};
  const bool is_teen = number % 100 / 10 == 1;
  const int last = is_teen ? 0 : number % 10;
  return fmt::format("{}{}", number, kEndings[last < 4 ? static_cast<std::size_t>(last) : 0]);
}

}  // namespace autoref::referee
