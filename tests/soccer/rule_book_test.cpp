// The rule books' numbers, checked against the league's documents.
#include "soccer/rules/rule_book.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace autoref {
namespace {

RuleBook book(const char* name) { return find_rule_book(name).value(); }

TEST(RuleBooks, AreFoundByNameOnly) {
  EXPECT_EQ(rule_book_names(),
            (std::vector<std::string>{"paper", "2014", "2014-double", "2026-b", "2026-a"}));
  EXPECT_FALSE(find_rule_book("2013").has_value());
  EXPECT_FALSE(find_game_setup("2013").has_value());
}

TEST(RuleBooks, LimitKicksTo8MetresPerSecondUntil2014AndTo6point5In2026) {
  EXPECT_DOUBLE_EQ(book("2014").kick_limit_mps, 8.0);
  EXPECT_DOUBLE_EQ(book("2026-b").kick_limit_mps, 6.5);
  EXPECT_DOUBLE_EQ(book("2026-a").kick_limit_mps, 6.5);
}

TEST(RuleBooks, AllowDribblingFor500MillimetresIn2014AndAMetreLater) {
  EXPECT_DOUBLE_EQ(book("2014").dribbling_m, 0.5);
  EXPECT_DOUBLE_EQ(book("2026-b").dribbling_m, 1.0);
}

TEST(RuleBooks, LimitTheSpeedDuringStopByTheSizeOfTheField) {
  EXPECT_DOUBLE_EQ(book("2014").stop_speed_mps, 1.0);
  EXPECT_DOUBLE_EQ(book("2014-double").stop_speed_mps, 1.5);
  EXPECT_DOUBLE_EQ(book("2026-a").stop_speed_mps, 1.5);
}

TEST(RuleBooks, LetKeepersHoldTheBallFor15And10And5Seconds) {
  EXPECT_DOUBLE_EQ(book("2014").keeper_holding_s, 15);
  EXPECT_DOUBLE_EQ(book("2026-b").keeper_holding_s, 10);
  EXPECT_DOUBLE_EQ(book("2026-a").keeper_holding_s, 5);
}

// Rules of 2026, change 103: 0.7 m of carpet, of which the outer 0.4 m are the referees' path
// behind the wall; division A has substitution areas behind the goal lines.
TEST(RuleBooks, HaveTheirWalls300MmFromTheLinesIn2026) {
  const Field b = find_game_setup("2026-b")->field;
  EXPECT_DOUBLE_EQ(b.wall_x_m(), 4.8);
  EXPECT_DOUBLE_EQ(b.wall_y_m(), 3.3);
  EXPECT_TRUE(b.goal_sides_reach_wall);
  const Field a = find_game_setup("2026-a")->field;
  EXPECT_DOUBLE_EQ(a.wall_x_m(), 6.6);
  EXPECT_DOUBLE_EQ(a.wall_y_m(), 4.8);
  EXPECT_TRUE(a.goal_sides_reach_wall);
}

TEST(RuleBooks, HadTheirWalls675MmFromTheLinesUntil2014) {
  for (const char* name : {"paper", "2014", "2014-double"}) {
    const Field field = find_game_setup(name)->field;
    EXPECT_DOUBLE_EQ(field.wall_x_m() - field.half_length_m(), 0.675) << name;
    EXPECT_DOUBLE_EQ(field.wall_y_m() - field.half_width_m(), 0.675) << name;
    EXPECT_FALSE(field.goal_sides_reach_wall) << name;
  }
}

TEST(RuleBooks, GrantTimeoutsByTheSizeOfTheField) {
  EXPECT_EQ(book("2014").timeouts, 4);
  EXPECT_DOUBLE_EQ(book("2014").timeouts_s, 300);
  EXPECT_EQ(book("2014-double").timeouts, 6);
  EXPECT_DOUBLE_EQ(book("2014-double").timeouts_s, 450);
}

TEST(RuleBooks, ForbidAimlessKicksInDivisionBOnly) {
  EXPECT_TRUE(book("2026-b").has(RuleId::kAimlessKick));
  EXPECT_FALSE(book("2026-a").has(RuleId::kAimlessKick));
  EXPECT_FALSE(book("2014").has(RuleId::kAimlessKick));
}

class EveryRuleBook : public testing::TestWithParam<std::string> {
 protected:
  RuleBook rules = book(GetParam().c_str());
};

// Laws 2014, law 8; 2026, "Choosing Side And Kick-Off". The paper's games do not change ends.
TEST_P(EveryRuleBook, LetsTeamsChangeEndsExceptThePapers) {
  EXPECT_EQ(rules.change_ends, GetParam() != "paper");
}

TEST_P(EveryRuleBook, HasNoOffsideUnlessItIsSwitchedOn) {
  EXPECT_FALSE(rules.has(RuleId::kOffside));
}

TEST(RuleBooks, OfThePaperContainTheRulesItDescribes) {
  const RuleSet expected{RuleId::kGoal, RuleId::kBallLeavesField,
                         RuleId::kAttackerTooCloseToDefenseArea, RuleId::kRestartNotTaken,
                         RuleId::kStuckBall};
  EXPECT_EQ(book("paper").in_force, expected);
  EXPECT_EQ(book("paper"), RuleBook{});
}

TEST(GameSetups, MatchTheDivisions) {
  const GameSetup a = find_game_setup("2026-a").value();
  EXPECT_DOUBLE_EQ(a.field.length_m, 12);
  EXPECT_DOUBLE_EQ(a.field.width_m, 9);
  EXPECT_DOUBLE_EQ(a.field.goal_width_m, 1.8);
  EXPECT_DOUBLE_EQ(a.field.defence_area.depth_m, 1.8);
  EXPECT_DOUBLE_EQ(a.field.defence_area.straight_m, 3.6);
  EXPECT_EQ(a.robots, 11);
  EXPECT_DOUBLE_EQ(a.half_s, 300);
  EXPECT_DOUBLE_EQ(find_game_setup("2014-double").value().field.length_m, 8.09);
  EXPECT_DOUBLE_EQ(find_game_setup("paper").value().half_s, 600);
}

TEST(RuleTable, ContainsEveryRuleOnceInOrder) {
  int next = 0;
  for (const RuleEntry& entry : rule_table()) {
    EXPECT_EQ(static_cast<int>(entry.rule), next++);
    EXPECT_FALSE(entry.name.empty()) << next;
    EXPECT_FALSE(entry.about.empty()) << entry.name;
  }
  EXPECT_EQ(next, kRuleCount);
}

std::vector<std::string> rules_without_section(const RuleBook& rules) {
  std::vector<std::string> names;
  for (const RuleEntry& entry : rule_table()) {
    const bool is_named = section_of(rules, entry.rule) != "AutoRef";
    if (rules.has(entry.rule) && !is_named) names.emplace_back(name_of(entry.rule));
  }
  return names;
}

TEST_P(EveryRuleBook, NamesASectionForEachOfItsRules) {
  EXPECT_EQ(rules_without_section(rules), std::vector<std::string>{});
}

INSTANTIATE_TEST_SUITE_P(Named, EveryRuleBook, testing::ValuesIn(rule_book_names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(RuleIds, AreFoundByTheirNames) {
  std::set<std::string_view> names;
  for (const RuleEntry& entry : rule_table()) {
    names.insert(name_of(entry.rule));
    EXPECT_EQ(find_rule(name_of(entry.rule)), entry.rule);
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(kRuleCount));
  EXPECT_FALSE(find_rule("handball").has_value());
}

}  // namespace
}  // namespace autoref
