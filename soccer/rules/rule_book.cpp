#include "soccer/rules/rule_book.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace autoref {
namespace {

struct Book {
  RuleBook rules;
  GameSetup setup;
};

// The defaults resemble real robots rather than those of the paper's simulator. Teams tune their
// latency by hand; two values in one team's public code differ by 12 ms (MinuteBots 2018).
void set_real_robots(GameSetup& setup) {
  setup.kickers_and_dribblers = "rc2026";
  setup.latency_error_s = 10_ms;
}

Book laws_2014() {
  Book book;
  set_real_robots(book.setup);
  book.rules.name = "2014";
  book.rules.edition = Edition::kLaws2014;
  book.rules.in_force = rules_of(Edition::kLaws2014);
  book.rules.change_ends = true;
  book.rules.penalty_prolongs_half = true;
  return book;
}

Book laws_2014_double() {
  Book book = laws_2014();
  book.rules.name = "2014-double";
  book.rules.stop_speed_mps = 1.5_mps;
  book.rules.timeouts = 6;
  book.rules.timeouts_s = 450_s;
  Field& field = book.setup.field;
  field.length_m = 8.09_m;
  field.width_m = 6.05_m;
  field.penalty_mark_m = 1.0_m;
  field.defence_area = {DefenceArea::Shape::kQuarterCircles, 1.0_m, 0.5_m};
  field.goal_width_m = 1.0_m;
  return book;
}

void set_rules_2026(RuleBook& rules) {
  rules.edition = Edition::kRules2026;
  rules.in_force = rules_of(Edition::kRules2026);
  rules.throw_in_inset_m = 200_mm;
  rules.corner_inset_m = 200_mm;
  rules.goal_kick_touch_inset_m = 200_mm;
  rules.goal_kick_goal_inset_m = 1_m;
  rules.free_kick_to_area_m = 1_m;
  rules.neutral_to_area_m = 1_m;
  rules.kicks_may_score = true;
  rules.untaken_goes_to_opponents = true;
  rules.kick_limit_mps = 6.5_mps;
  rules.dribbling_m = 1_m;
  rules.stop_speed_mps = 1.5_mps;
  rules.fouls_stop_play = false;
  rules.penalty_clearance_m = 1_m;
  rules.penalty_fouls_decide = true;
  rules.penalty_prolongs_half = true;
  rules.fouls_per_card = 3;
  rules.yellows_per_red = 3;
  rules.goals_to_win = 10;
  rules.clock_stops = true;
  rules.change_ends = true;
  rules.extra_half_s = 150_s;
  rules.extra_timeouts_s = 150_s;
}

Book rules_2026_b() {
  Book book;
  set_real_robots(book.setup);
  book.rules.name = "2026-b";
  set_rules_2026(book.rules);
  book.rules.keeper_holding_s = 10_s;
  book.setup.half_s = 300_s;
  Field& field = book.setup.field;
  field.length_m = 9_m;
  field.width_m = 6_m;
  // The remaining 0.4 m of carpet are the referees' path outside the wall (change 103 of
  // 2026-02-25).
  field.run_off_m = 0.3_m;
  field.goal_sides_reach_wall = true;
  field.penalty_mark_m = 6_m;
  field.defence_area = {DefenceArea::Shape::kBox, 1.0_m, 2.0_m};
  field.goal_width_m = 1.0_m;
  return book;
}

Book rules_2026_a() {
  Book book = rules_2026_b();
  book.rules.name = "2026-a";
  book.rules.in_force[RuleId::kAimlessKick] = false;
  book.rules.keeper_holding_s = 5_s;
  book.rules.free_kick_timeout_s = 5_s;
  book.rules.stuck_time_s = 5_s;
  book.setup.robots = 11;
  Field& field = book.setup.field;
  field.length_m = 12_m;
  field.width_m = 9_m;
  field.goal_line_run_off_m = 0.6_m;
  field.penalty_mark_m = 8_m;
  field.defence_area = {DefenceArea::Shape::kBox, 1.8_m, 3.6_m};
  field.goal_width_m = 1.8_m;
  return book;
}

std::vector<Book> all_books() {
  return {Book{}, laws_2014(), laws_2014_double(), rules_2026_b(), rules_2026_a()};
}

std::optional<Book> find_book(std::string_view name) {
  for (Book& book : all_books()) {
    if (book.rules.name == name) return std::move(book);
  }
  return std::nullopt;
}

// X macro: rules.def expands to one row per rule.
constexpr std::array<RuleEntry, kRuleCount> kTable = {{
#define AUTOREF_RULE(id, ...) {.rule = RuleId::id, __VA_ARGS__},
#include "soccer/parameters.hpp"
#include "soccer/rules/rules.def"
#undef AUTOREF_RULE
}};

// The unit of each rule's threshold, from the threshold's name.
std::array<std::string_view, kRuleCount> threshold_units() {
  std::array<std::string_view, kRuleCount> units;
  const RuleBook book;
  for (const RuleEntry& entry : kTable) {
    if (entry.threshold == nullptr) continue;
    const void* const threshold = &(book.*entry.threshold);
    RuleBook::visit(book, [&](const auto& number, const Parameter& parameter) {
      if (&number == threshold)
        units[static_cast<std::size_t>(entry.rule)] = unit_of(parameter.name);
    });
  }
  return units;
}

bool has_threshold(const RuleBook& rules, double RuleBook::*threshold) {
  const auto table = rule_table();
  return std::any_of(table.begin(), table.end(), [&](const RuleEntry& entry) {
    return entry.threshold == threshold && rules.has(entry.rule);
  });
}

}  // namespace

std::optional<RuleBook> find_rule_book(std::string_view name) {
  const std::optional<Book> book = find_book(name);
  return book ? std::optional(book->rules) : std::nullopt;
}

std::optional<GameSetup> find_game_setup(std::string_view name) {
  const std::optional<Book> book = find_book(name);
  return book ? std::optional(book->setup) : std::nullopt;
}

std::vector<std::string> rule_book_names() {
  std::vector<std::string> names;
  for (const Book& book : all_books()) names.push_back(book.rules.name);
  return names;
}

std::string_view RuleEntry::section(Edition edition) const {
  const std::array<std::string_view, 3> sections = {paper, laws_2014, rules_2026};
  return sections[static_cast<std::size_t>(edition)];
}

std::string_view RuleEntry::unit() const {
  static const std::array<std::string_view, kRuleCount> kUnits = threshold_units();
  return kUnits[static_cast<std::size_t>(rule)];
}

std::span<const RuleEntry> rule_table() { return kTable; }

const RuleEntry& entry_of(RuleId rule) { return kTable[static_cast<std::size_t>(rule)]; }

std::string_view section_of(const RuleBook& rules, RuleId rule) {
  const std::string_view section = entry_of(rule).section(rules.edition);
  return section.empty() ? "AutoRef" : section;
}

std::string_view name_of(RuleId rule) { return entry_of(rule).name; }

std::optional<RuleId> find_rule(std::string_view name) {
  const auto found = std::find_if(kTable.begin(), kTable.end(),
                                  [name](const RuleEntry& entry) { return entry.name == name; });
  return found == kTable.end() ? std::nullopt : std::optional(found->rule);
}

RuleSet rules_of(Edition edition) {
  RuleSet rules;
  for (const RuleEntry& entry : kTable) rules[entry.rule] = !entry.section(edition).empty();
  return rules;
}

RuleBook obeyed_rules(const RuleBook& match, const RuleBook& laws) {
  RuleBook obeyed = match;
  for (const RuleEntry& entry : rule_table()) {
    if (match.has(entry.rule) || !laws.has(entry.rule) || !entry.of_conduct) continue;
    obeyed.in_force[entry.rule] = true;
    if (entry.threshold != nullptr && !has_threshold(match, entry.threshold))
      obeyed.*entry.threshold = laws.*entry.threshold;
  }
  return obeyed;
}

}  // namespace autoref
