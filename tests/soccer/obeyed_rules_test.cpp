#include "soccer/rules/rule_book.hpp"

#include <gtest/gtest.h>

#include <string>

namespace autoref {
namespace {

RuleBook laws_named(const std::string& name) { return find_rule_book(name).value(); }

TEST(ObeyedRules, UnderThePapersBookAreTheRulesOfConductOf2014) {
  const RuleBook obeyed = obeyed_rules(laws_named("paper"), laws_named("2014"));
  EXPECT_TRUE(obeyed.has(RuleId::kBotDribbledBallTooFar));
  EXPECT_DOUBLE_EQ(obeyed.dribbling_m, 0.5);
  EXPECT_TRUE(obeyed.has(RuleId::kAttackerDoubleTouchedBall));
  EXPECT_TRUE(obeyed.has(RuleId::kBotKickedBallTooFast));
  EXPECT_DOUBLE_EQ(obeyed.kick_limit_mps, 8.0);
  EXPECT_FALSE(obeyed.has(RuleId::kAttackerTouchedBallInDefenseArea));
}

TEST(ObeyedRules, HaveTheNumbersOfTheLawsForWhatTheMatchDoesNotEnforce) {
  const RuleBook obeyed = obeyed_rules(laws_named("paper"), laws_named("2026-b"));
  EXPECT_DOUBLE_EQ(obeyed.dribbling_m, 1.0);
  EXPECT_DOUBLE_EQ(obeyed.kick_limit_mps, 6.5);
  EXPECT_DOUBLE_EQ(obeyed.stop_speed_mps, 1.5);
}

TEST(ObeyedRules, HaveTheNumbersOfTheMatchForWhatItEnforces) {
  const RuleBook obeyed = obeyed_rules(laws_named("2026-a"), laws_named("2014"));
  EXPECT_DOUBLE_EQ(obeyed.dribbling_m, 1.0);
  EXPECT_DOUBLE_EQ(obeyed.kick_limit_mps, 6.5);
  EXPECT_TRUE(obeyed.has(RuleId::kStopDistance));
}

TEST(ObeyedRules, KeepTheMatchsThresholdThatTwoRulesShare) {
  RuleBook match = laws_named("2026-b");
  match.opponents_to_ball_m = 0.4;
  EXPECT_DOUBLE_EQ(obeyed_rules(match, laws_named("2014")).opponents_to_ball_m, 0.4);
  EXPECT_TRUE(obeyed_rules(match, laws_named("2014")).has(RuleId::kStopDistance));
}

TEST(ObeyedRules, LeaveTheCourseOfTheGameToTheMatch) {
  const RuleBook match = laws_named("paper");
  for (const std::string& laws : rule_book_names()) {
    const RuleBook obeyed = obeyed_rules(match, laws_named(laws));
    for (const RuleEntry& entry : rule_table()) {
      if (entry.of_conduct) continue;
      EXPECT_EQ(obeyed.has(entry.rule), match.has(entry.rule)) << laws << ' ' << entry.name;
    }
    EXPECT_EQ(obeyed.edition, match.edition);
    EXPECT_EQ(obeyed.fouls_per_card, match.fouls_per_card);
  }
}

TEST(ObeyedRules, AreThoseInForceIfTheMatchEnforcesTheLaws) {
  for (const std::string& name : rule_book_names())
    EXPECT_EQ(obeyed_rules(laws_named(name), laws_named(name)), laws_named(name));
}

}  // namespace
}  // namespace autoref
