#include "soccer/rules/rule_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <type_traits>

#include "soccer/parameters.hpp"

namespace autoref {
namespace {

std::string words_of(std::string_view name) {
  std::string words(without_unit(name));
  std::replace_if(
      words.begin(), words.end(), [](char c) { return c == '_' || c == '.'; }, ' ');
  return words;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

// "double touch 150 mm (50)". Lengths below one metre are in millimetres.
std::string number_text(std::string_view name, double value, double official) {
  std::string_view unit = unit_of(name);
  double scale = 1;
  if (unit == "m" && std::max(value, official) < 1) {
    unit = "mm";
    scale = 1000;
  }
  return fmt::format("{} {:.6g}{}{} ({:.6g})", words_of(name), scale * value,
                     unit.empty() ? "" : " ", unit, scale * official);
}

std::string change_text(std::string_view name, bool value, bool official) {
  return fmt::format("{} {} ({})", words_of(name), yes_or_no(value), yes_or_no(official));
}

// The official value is a number, as in values_of().
template <typename Value>
std::string change_text(std::string_view name, const Value& value, double official) {
  if constexpr (HasNames<Value>) {
    const auto official_value = static_cast<Value>(static_cast<int>(official));
    return fmt::format("{} {} ({})", words_of(name), words_of(name_of(value)),
                       words_of(name_of(official_value)));
  } else if constexpr (std::is_same_v<Value, bool>) {
    return change_text(name, value, official != 0);
  } else {
    return number_text(name, static_cast<double>(value), official);
  }
}

// All parameters as numbers, in order.
template <typename Of>
std::vector<double> values_of(const Of& of) {
  std::vector<double> values;
  visit_all(of, "", [&values](const auto& value, const Parameter&, const std::string&) {
    values.push_back(static_cast<double>(value));
  });
  return values;
}

// Adds the parameters of `of` that differ from those of `official`. `path` maps a parameter's name
// to its setting.
template <typename Of, typename Path>
void add_changes(const Of& of, const Of& official, const Path& path,
                 std::vector<RuleChange>& changes) {
  const std::vector<double> values = values_of(official);
  std::size_t next = 0;
  visit_all(of, "", [&](const auto& value, const Parameter&, const std::string& name) {
    const double official_value = values[next++];
    if (static_cast<double>(value) != official_value)
      changes.push_back({path(name), change_text(name, value, official_value)});
  });
}

// A bound on a number that follows from another number or from the field.
struct Bound {
  double most = 0;
  std::string what;  // "double_touch_m"
  std::string_view why;
};

using Number = double RuleBook::*;

// Checks numbers that differ from the official ones.
class NumberChecker {
 public:
  NumberChecker(const RuleBook& rules, const RuleBook& official)
      : rules_(rules), official_(official) {}

  // `others` are the numbers on which the bound depends.
  void at_most(Number number, const Bound& bound, std::initializer_list<Number> others = {}) const {
    const bool is_any_changed =
        is_changed(number) || std::any_of(others.begin(), others.end(),
                                          [this](Number other) { return is_changed(other); });
    if (!is_any_changed || rules_.*number <= bound.most) return;
    refuse_value(name_of(number), rules_.*number,
                 fmt::format("at most {} ({:.6g}), because {}", bound.what, bound.most, bound.why));
  }

  void at_most(Number number, Number other, std::string_view why) const {
    at_most(number, {rules_.*other, name_of(other), why}, {other});
  }

 private:
  bool is_changed(Number number) const { return rules_.*number != official_.*number; }

  std::string name_of(Number number) const {
    std::string name;
    RuleBook::visit(rules_, [&](const auto& value, const Parameter& about) {
      const void* const its = &value;
      if (its == &(rules_.*number)) name = about.name;
    });
    return name;
  }

  const RuleBook& rules_;
  const RuleBook& official_;
};

void check_numbers(const NumberChecker& check) {
  check.at_most(&RuleBook::in_play_m, &RuleBook::double_touch_m,
                "a second touch is a foul only once the ball is in play");
  for (const Number timeout : {&RuleBook::ready_timeout_s, &RuleBook::start_timeout_s}) {
    check.at_most(&RuleBook::readiness_period_s, timeout,
                  "otherwise the wait is over before the first check");
  }
  check.at_most(&RuleBook::attacker_to_area_m, &RuleBook::free_kick_to_area_m,
                "otherwise the kicker is too near to the area");
  check.at_most(&RuleBook::placement_least_s, &RuleBook::placement_time_s,
                "otherwise no team can place the ball in time");
  check.at_most(&RuleBook::ball_in_position_m, &RuleBook::placement_tolerance_m,
                "a ball that is in position has been placed");
}

// A ball counts as at rest after the time in which it would roll across its position at the resting
// speed. This must not take longer than the referee waits.
void check_resting_time(const RuleBook& rules, const NumberChecker& check) {
  const double wait_s = std::min(rules.ready_timeout_s, rules.placement_time_s);
  check.at_most(
      &RuleBook::ball_in_position_m,
      {rules.ball_at_rest_mps * wait_s / 2,
       "ball_at_rest_mps times half of ready_timeout_s or placement_time_s",
       "otherwise no ball comes to rest in time"},
      {&RuleBook::ball_at_rest_mps, &RuleBook::ready_timeout_s, &RuleBook::placement_time_s});
}

// Positions of restarts must be on the field, and outside the defence areas.
void check_room(const RuleBook& rules, const Field& field, const NumberChecker& check) {
  constexpr std::string_view kOnField = "the position must be on the field";
  constexpr std::string_view kOutside = "there must be a position outside both areas";
  const Bound half_width{field.half_width_m(), "half the field's width", kOnField};
  const Bound half_length{field.half_length_m(), "half the field's length", kOnField};
  check.at_most(&RuleBook::throw_in_inset_m, half_width);
  check.at_most(&RuleBook::corner_inset_m, half_width);
  check.at_most(&RuleBook::goal_kick_touch_inset_m, half_width);
  check.at_most(&RuleBook::own_area_kick_touch_inset_m, half_width);
  check.at_most(&RuleBook::goal_kick_goal_inset_m, half_length);
  check.at_most(&RuleBook::own_area_kick_goal_inset_m, half_length);
  const Bound to_area{field.half_length_m() - field.defence_area.depth_m,
                      "the distance between a defence area and the halfway line", kOutside};
  check.at_most(&RuleBook::free_kick_to_area_m, to_area);
  check.at_most(&RuleBook::neutral_to_area_m, to_area);
  if (rules.edition == Edition::kRules2026) {
    // A free kick next to an area is taken from the side of the area
    // (referee/geometry/restarts.hpp).
    const double beside_m =
        field.half_width_m() - field.defence_area.straight_m / 2 - rules.throw_in_inset_m;
    check.at_most(&RuleBook::free_kick_to_area_m,
                  {beside_m, "the distance between a defence area and the throw-ins", kOutside});
  }
  check.at_most(&RuleBook::penalty_clearance_m,
                {field.length_m - field.penalty_mark_m,
                 "the distance between the penalty mark and the other goal line",
                 "the robots must be on the field"});
}

}  // namespace

std::string path_of_number(std::string_view name) {
  const bool is_of_match =
      std::find(kNumbersOfMatch.begin(), kNumbersOfMatch.end(), name) != kNumbersOfMatch.end();
  return fmt::format("{}{}", is_of_match ? "match." : kRuleNumberBranch, name);
}

std::vector<RuleChange> rule_changes(const RuleBook& rules, const Field& field) {
  std::vector<RuleChange> changes;
  const std::optional<RuleBook> official = find_rule_book(rules.name);
  if (!official) return changes;
  add_changes(rules, *official, path_of_number, changes);
  for (const RuleEntry& entry : rule_table()) {
    const bool is_on = rules.has(entry.rule);
    if (is_on == official->has(entry.rule)) continue;
    changes.push_back({fmt::format("{}{}", kRuleSwitchBranch, entry.name),
                       change_text(entry.name, is_on, !is_on)});
  }
  add_changes(
      field, find_game_setup(rules.name)->field,
      [](const std::string& name) { return "field." + name; }, changes);
  return changes;
}

std::string text_of(const std::vector<RuleChange>& changes) {
  std::string list;
  for (const RuleChange& change : changes) list += (list.empty() ? "" : "; ") + change.text;
  return list;
}

std::string not_official_text(const std::string& list) {
  return list.empty() ? "" : "not the official rules: " + list;
}

std::string name_with_changes(const std::string& book, const std::string& list) {
  return list.empty() ? book : fmt::format("{}, {}", book, not_official_text(list));
}

void check_rules(const RuleBook& rules, const Field& field) {
  const std::optional<RuleBook> official = find_rule_book(rules.name);
  if (!official) return;
  const NumberChecker check(rules, *official);
  check_numbers(check);
  check_resting_time(rules, check);
  check_room(rules, field, check);
}

}  // namespace autoref
