#include "league/team/rule_numbers.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "tests/checkout.hpp"

namespace autoref::league {
namespace {

std::set<std::string> names_of(const RuleBook& rules) {
  std::set<std::string> names;
  visit_rule_numbers(rules, [&names](std::string_view name, double) {
    EXPECT_TRUE(names.emplace(name).second) << name;
  });
  return names;
}

// The members that soccer/rule_book.hpp declares.
std::set<std::string> declared_members() {
  std::ostringstream text;
  text << std::ifstream(in_checkout("soccer/rule_book.hpp")).rdbuf();
  const std::string all = text.str();
  const std::size_t begin = all.find("struct RuleBook");
  const std::string book = all.substr(begin, all.find("\n};", begin) - begin);
  const std::regex declaration(R"(\n  (double|int|bool) (\w+) =)");
  std::set<std::string> members;
  for (std::sregex_iterator i(book.begin(), book.end(), declaration), end; i != end; ++i)
    members.insert((*i)[2]);
  return members;
}

TEST(RuleNumbers, NameEveryMemberOfARuleBook) {
  const std::set<std::string> names = names_of(RuleBook{});
  const std::set<std::string> members = declared_members();
  EXPECT_GT(members.size(), 50U);
  for (const std::string& member : members) EXPECT_TRUE(names.contains(member)) << member;
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
