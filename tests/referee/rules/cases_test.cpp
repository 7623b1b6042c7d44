// Tests the referee against the rule books: every case of cases/*.yaml, as written and turned by
// 180 degrees with the sides swapped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

#include "soccer/rules/rule_book.hpp"
#include "tests/checkout.hpp"
#include "tests/referee/rules/case_reader.hpp"
#include "tests/referee/rules/staged_game.hpp"

namespace autoref::referee {
namespace {

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases = read_cases(in_checkout("tests/referee/rules/cases"));
  return cases;
}

// "A ball on the line is not out" becomes "ball_leaves_field_ABallOnTheLineIsNotOut".
std::string test_name(const Case& it) {
  std::string name = it.rule + "_";
  bool begins_word = true;
  for (const char letter : it.name) {
    const bool is_letter = std::isalnum(static_cast<unsigned char>(letter)) != 0;
    if (is_letter) {
      name += begins_word ? static_cast<char>(std::toupper(letter)) : letter;
    }
    begins_word = !is_letter && letter != '\'';
  }
  return name;
}

std::string described(const std::vector<Call>& calls) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3);
  for (const Call& call : calls) {
    text << "\n  " << call.at_s << " s " << name_of(call.decision.finding.event) << " by";
    for (const RobotId& robot : call.decision.finding.robots) {
      text << " " << name_of(robot.side) << " " << robot.number;
    }
    if (call.decision.finding.offender)
      text << ", offender " << name_of(*call.decision.finding.offender);
    if (call.decision.finding.card != Card::kNone)
      text << ", card " << name_of(call.decision.finding.card);
    if (call.next) text << ", next " << name_of(*call.next);
    if (call.ball_m) text << " from " << call.ball_m->transpose();
    text << " (" << call.decision.finding.evidence << ")";
  }
  return calls.empty() ? "\n  no call" : text.str();
}

bool has_robots(const Call& call, std::vector<RobotId> wanted) {
  std::vector<RobotId> robots(call.decision.finding.robots.begin(),
                              call.decision.finding.robots.end());
  std::sort(robots.begin(), robots.end());
  std::sort(wanted.begin(), wanted.end());
  return robots == wanted;
}

bool is_as_expected(const Call& call, const Expected& expected) {
  return call.decision.finding.event == expected.event && call.at_s >= expected.from_s &&
         call.at_s <= expected.to_s && (!expected.robots || has_robots(call, *expected.robots)) &&
         (!expected.offender || call.decision.finding.offender == expected.offender) &&
         (!expected.card || call.decision.finding.card == expected.card) &&
         (!expected.next || call.next == expected.next) &&
         (!expected.ball_m ||
          (call.ball_m && (*call.ball_m - *expected.ball_m).norm() <= expected.within_m));
}

// Removes the expected calls from `calls`. Returns the missing ones.
std::string take_expected(const Case& it, std::vector<Call>& calls) {
  std::string missing;
  for (const Expected& expected : it.expected) {
    const auto found = std::find_if(calls.begin(), calls.end(), [&](const Call& call) {
      return is_as_expected(call, expected);
    });
    if (found == calls.end()) {
      missing += " " + std::string(name_of(expected.event));
    } else {
      calls.erase(found);
    }
  }
  return missing;
}

void check(const Case& it, const StagedGame& game) {
  std::vector<Call> others = game.calls();
  const std::string missing = take_expected(it, others);
  EXPECT_TRUE(missing.empty()) << "not called as expected:" << missing;
  for (const Call& call : others) {
    const bool is_forbidden = !it.others_allowed || std::count(it.never.begin(), it.never.end(),
                                                               call.decision.finding.event) > 0;
    EXPECT_FALSE(is_forbidden) << "called wrongly: " << name_of(call.decision.finding.event);
  }
  if (it.goals) {
    EXPECT_EQ(game.goals()[Side::kWest], (*it.goals)[Side::kWest]) << "goals of west";
    EXPECT_EQ(game.goals()[Side::kEast], (*it.goals)[Side::kEast]) << "goals of east";
  }
}

void play(const Case& it, bool turned) {
  SCOPED_TRACE(it.location + ": " + it.name);
  ASSERT_TRUE(it.error.empty()) << it.error;
  try {
    StagedGame game(it, turned);
    game.play();
    check(it, game);
    if (testing::Test::HasFailure()) ADD_FAILURE() << "calls:" << described(game.calls());
  } catch (const std::exception& error) {
    ADD_FAILURE() << error.what();
  }
}

class RuleCase : public testing::TestWithParam<Case> {};

TEST_P(RuleCase, FollowsTheRuleBook) { play(GetParam(), false); }
TEST_P(RuleCase, FollowsTheRuleBookWhenTurned) { play(GetParam(), true); }

std::string name_of_parameter(const testing::TestParamInfo<Case>& info) {
  return test_name(info.param);
}

INSTANTIATE_TEST_SUITE_P(Cases, RuleCase, testing::ValuesIn(all_cases()), name_of_parameter);

struct Counted {
  int all = 0;
  int negative = 0;
};

std::map<std::string, Counted> count_by_rule() {
  std::map<std::string, Counted> counted;
  for (const Case& it : all_cases()) {
    counted[it.rule].all += 1;
    counted[it.rule].negative += it.is_negative ? 1 : 0;
  }
  return counted;
}

TEST(RuleCases, ExistAtLeastThreePerRule) {
  for (int i = 0; i < kRuleCount; ++i) {
    const std::string rule(name_of(static_cast<RuleId>(i)));
    EXPECT_GE(count_by_rule()[rule].all, 3) << rule;
  }
}

TEST(RuleCases, AThirdPerRuleExpectNoCall) {
  for (const auto& [rule, counted] : count_by_rule()) {
    EXPECT_GE(counted.negative * 3, counted.all) << rule;
  }
}

}  // namespace
}  // namespace autoref::referee
