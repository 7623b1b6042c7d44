#include "soccer/rules/rule_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
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

// `value` and the official value as a number, as in values_of().
template <typename Value>
std::string change_text(std::string_view name, const Value& value, double official) {
  if constexpr (HasNames<Value>) {
    const auto its = static_cast<Value>(static_cast<int>(official));
    return fmt::format("{} {} ({})", words_of(name), words_of(name_of(value)),
                       words_of(name_of(its)));
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
    const double its = values[next++];
    if (static_cast<double>(value) != its)
      changes.push_back({path(name), change_text(name, value, its)});
  });
}

// The largest value of a number, if the rest of the rules or the field limits it.
void check_at_most(const char* number, double value, double most, const std::string& why) {
  if (value > most) refuse_value(number, value, fmt::format("at most {:.6g}, {}", most, why));
}

void check_numbers(const RuleBook& rules) {
  check_at_most("in_play_m", rules.in_play_m, rules.double_touch_m,
                "double_touch_m: a second touch is a foul only once the ball is in play");
  check_at_most("readiness_period_s", rules.readiness_period_s, rules.ready_timeout_s,
                "ready_timeout_s: the wait would be over before the first check");
  check_at_most("attacker_to_area_m", rules.attacker_to_area_m, rules.free_kick_to_area_m,
                "free_kick_to_area_m: the kicker itself would be too near to the area");
  check_at_most("placement_least_s", rules.placement_least_s, rules.placement_time_s,
                "placement_time_s: the team could never place the ball in time");
  check_at_most("ball_in_position_m", rules.ball_in_position_m, rules.placement_tolerance_m,
                "placement_tolerance_m");
}

// Positions of restarts must be on the field, and outside the defence areas.
void check_room(const RuleBook& rules, const Field& field) {
  const double wide_m = field.half_width_m();
  const double long_m = field.half_length_m();
  const double before_area_m = long_m - field.defence_area.depth_m;
  const std::string half_width = "half the field's width";
  const std::string half_length = "half the field's length";
  const std::string to_area = "the distance from the defence area to the halfway line";
  check_at_most("throw_in_inset_m", rules.throw_in_inset_m, wide_m, half_width);
  check_at_most("corner_inset_m", rules.corner_inset_m, wide_m, half_width);
  check_at_most("goal_kick_touch_inset_m", rules.goal_kick_touch_inset_m, wide_m, half_width);
  check_at_most("own_area_kick_touch_inset_m", rules.own_area_kick_touch_inset_m, wide_m,
                half_width);
  check_at_most("goal_kick_goal_inset_m", rules.goal_kick_goal_inset_m, long_m, half_length);
  check_at_most("own_area_kick_goal_inset_m", rules.own_area_kick_goal_inset_m, long_m,
                half_length);
  check_at_most("free_kick_to_area_m", rules.free_kick_to_area_m, before_area_m, to_area);
  check_at_most("neutral_to_area_m", rules.neutral_to_area_m, before_area_m, to_area);
  check_at_most("penalty_clearance_m", rules.penalty_clearance_m,
                field.length_m - field.penalty_mark_m,
                "the distance from the penalty mark to the other goal line");
}

}  // namespace

std::string path_of_number(std::string_view name) {
  const bool is_of_match = name == "extra_half_s" || name == "change_ends";
  return fmt::format("{}{}", is_of_match ? "match." : kRuleNumbers, name);
}

std::vector<RuleChange> rule_changes(const RuleBook& rules, const Field& field) {
  std::vector<RuleChange> changes;
  const std::optional<RuleBook> official = find_rule_book(rules.name);
  if (!official) return changes;
  add_changes(rules, *official, path_of_number, changes);
  for (const RuleEntry& entry : rule_table()) {
    const bool is_on = rules.has(entry.rule);
    if (is_on == official->has(entry.rule)) continue;
    changes.push_back(
        {fmt::format("{}{}", kRuleSwitches, entry.name), change_text(entry.name, is_on, !is_on)});
  }
  add_changes(
      field, find_game_setup(rules.name)->field,
      [](const std::string& name) { return "field." + name; }, changes);
  return changes;
}

std::string list_of(const std::vector<RuleChange>& changes) {
  std::string list;
  for (const RuleChange& change : changes) list += (list.empty() ? "" : "; ") + change.text;
  return list;
}

std::string not_official_text(const std::string& list) {
  return list.empty() ? "" : "not the official rules: " + list;
}

void check_rules(const RuleBook& rules, const Field& field) {
  // Official numbers are valid on any field.
  if (find_rule_book(rules.name) == rules) return;
  check_numbers(rules);
  check_room(rules, field);
}

}  // namespace autoref
