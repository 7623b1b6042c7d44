#include "league/team/team_messages.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "tests/league/team/start_numbers.hpp"

namespace autoref::league {
namespace {

std::set<std::string> names_of(const RuleBook& rules) {
  std::set<std::string> names;
  visit_rule_numbers(rules, [&names](std::string_view name, double) {
    EXPECT_TRUE(names.emplace(name).second) << name;
  });
  return names;
}

// Its numbers, the edition, and the rules in force.
TEST(RuleNumbers, HaveNamesOfTheirOwn) {
  EXPECT_EQ(names_of(RuleBook{}).size(), parameter_names<RuleBook>().size() + 1 + kRuleCount);
}

TEST(RuleNumbers, ContainTheRulesInForce) {
  std::map<std::string, double> numbers;
  visit_rule_numbers(*find_rule_book("2026-b"), [&numbers](std::string_view name, double value) {
    numbers.emplace(name, value);
  });
  EXPECT_EQ(numbers.at("in_force.aimless_kick"), 1);
  EXPECT_EQ(numbers.at("in_force.chipped_goal"), 0);
  EXPECT_EQ(numbers.at("edition"), 2);
  EXPECT_EQ(numbers.at("goals_to_win"), 10);
  EXPECT_EQ(numbers.at("clock_stops"), 1);
}

TEST(RuleNumbers, GiveTheWholeRuleBookBack) {
  for (const std::string& name : rule_book_names()) {
    TeamStart start;
    start.rules = *find_rule_book(name);
    start.obeyed = find_rule_book("2014")->in_force;
    TeamStart read;
    read.rules.name = name;
    visit_start_numbers(start, [&](std::string_view number, double value) {
      EXPECT_TRUE(set_start_number(read, number, value)) << number;
    });
    EXPECT_EQ(read.rules, start.rules);
    EXPECT_EQ(read.obeyed, start.obeyed);
  }
}

TEST(RuleNumbers, DistinguishTheRulesInForceFromThoseThatTheTeamKeepsTo) {
  TeamStart start;
  start.obeyed[RuleId::kBotDribbledBallTooFar] = true;
  std::map<std::string, double> numbers;
  visit_start_numbers(
      start, [&numbers](std::string_view name, double value) { numbers.emplace(name, value); });
  EXPECT_EQ(numbers.at("in_force.bot_dribbled_ball_too_far"), 0);
  EXPECT_EQ(numbers.at("obeyed.bot_dribbled_ball_too_far"), 1);
}

TEST(RuleNumbers, ContainTheDistanceToTheWallBehindTheGoalLines) {
  TeamStart start;
  std::vector<double> last;
  for (const double behind_m : {0.0, 0.6}) {
    start.field.goal_line_run_off_m = behind_m;
    visit_start_numbers(start, [&last](std::string_view name, double value) {
      if (name == "field.goal_line_run_off_m") last.push_back(value);
    });
  }
  EXPECT_EQ(last, (std::vector<double>{start.field.run_off_m, 0.6}));
}

TEST(RuleNumbers, SayWhetherTheGoalsSideWallsReachTheWall) {
  for (const bool reach : {false, true}) {
    TeamStart start;
    start.field.goal_sides_reach_wall = reach;
    TeamStart read;
    visit_start_numbers(
        start, [&](std::string_view name, double value) { set_start_number(read, name, value); });
    EXPECT_EQ(read.field.goal_sides_reach_wall, reach);
  }
}

TEST(RuleNumbers, RefuseUnknownNames) {
  TeamStart start;
  EXPECT_FALSE(set_start_number(start, "kick_limit", 1));
  EXPECT_FALSE(set_start_number(start, "in_force.aimless", 1));
  EXPECT_FALSE(set_start_number(start, "obeyed.aimless", 1));
}

}  // namespace
}  // namespace autoref::league
