#include "experiments/analysis/effects.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "experiments/analysis/summary.hpp"

namespace autoref::experiments {
namespace {

// Three robots' numbers by two numbers: the score difference of pair k in each combination.
using DifferenceOf = std::function<int(int a, int b, int pair)>;

const std::vector<Factor> kTwoFactors = {{"a.robots", {6, 5, 4}}, {"b.robots", {6, 5}}};

std::vector<Effect> effects_with(int pairs, const DifferenceOf& score,
                                 const std::string& lost = {}) {
  RowsById rows;
  for (int a = 6; a >= 4; --a) {
    for (int b = 6; b >= 5; --b) {
      for (int leg = 1; leg <= 2 * pairs; ++leg) {
        GameRow row;
        row.pair = (leg + 1) / 2;
        row.leg = 2 - leg % 2;
        row.record.goals_a = 50 + score(a, b, row.pair);
        row.record.goals_b = 50;
        row.record.status = game::Status::kOk;
        row.values = {std::to_string(a), std::to_string(b)};
        const std::string id = fmt::format("{}-{}-{}", a, b, leg);
        if (id != lost) rows[id] = row;
      }
    }
  }
  return effects_of(kTwoFactors, grouped(kTwoFactors, rows));
}

std::vector<std::string> names_of(const std::vector<Effect>& effects) {
  std::vector<std::string> names;
  for (const Effect& effect : effects) names.push_back(effect_name(effect));
  return names;
}

TEST(Effects, AreThoseOfEveryLaterValueAndEveryTwoOfThem) {
  EXPECT_EQ(names_of(effects_with(2, [](int, int, int) { return 0; })),
            (std::vector<std::string>{"a.robots 5", "a.robots 4", "b.robots 5",
                                      "a.robots 5, b.robots 5", "a.robots 4, b.robots 5"}));
}

// With a difference of 3 a + 2 b, and pairs that differ by a constant.
TEST(Effects, OfFactorsThatAddUpHaveNoInteraction) {
  const auto effects = effects_with(3, [](int a, int b, int pair) { return 3 * a - 2 * b + pair; });
  const std::vector<double> expected = {-3, -6, 2, 0, 0};
  ASSERT_EQ(effects.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(effects[i].mean, expected[i], 1e-12) << effect_name(effects[i]);
    EXPECT_EQ(effects[i].pairs, 3U);
  }
}

// A product of deviations from the first values: its main effects are averages over the other
// factor's values, and its interactions are the whole of it.
TEST(Effects, OfAProductAreItsAveragesAndInteractions) {
  const auto effects = effects_with(2, [](int a, int b, int) { return (6 - a) * (6 - b) * 4; });
  const std::vector<double> expected = {2, 4, 4, 4, 8};
  ASSERT_EQ(effects.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(effects[i].mean, expected[i], 1e-12) << effect_name(effects[i]);
}

// By hand: the effect of a.robots 5 is 1, 2 and 3 goals in the three pairs, so its interval is
// 2 -+ t(0.975, 2) / sqrt(3) with t = 4.302653.
TEST(Effects, HaveStudentsIntervalsOverPairs) {
  const auto effects = effects_with(3, [](int a, int, int pair) { return a == 5 ? pair : 0; });
  ASSERT_TRUE(effects[0].interval);
  EXPECT_NEAR(effects[0].interval->low, 2 - 4.302653 / std::sqrt(3.0), 1e-5);
  EXPECT_NEAR(effects[0].interval->high, 2 + 4.302653 / std::sqrt(3.0), 1e-5);
  EXPECT_FALSE(effects[1].interval) << "all pairs agree";
  ASSERT_TRUE(effects[0].p && effects[0].p_holm);
  EXPECT_EQ(*effects[0].p, *effects[0].p_holm) << "the only one with a p";
}

TEST(Effects, LeaveOutPairsWithAMissingGame) {
  const auto effects = effects_with(
      3, [](int a, int, int) { return a; }, "4-5-3");
  ASSERT_FALSE(effects.empty());
  for (const Effect& effect : effects) EXPECT_EQ(effect.pairs, 2U);
}

TEST(Effects, NeedTwoFactors) {
  const std::vector<Factor> one = {{"b.robots", {6, 5}}};
  EXPECT_TRUE(effects_of(one, grouped(one, RowsById{})).empty());
  EXPECT_TRUE(effects_table({}).empty());
}

TEST(Effects, AreShownWithIntervals) {
  const auto effects = effects_with(3, [](int a, int, int pair) { return a == 5 ? pair : 0; });
  const std::string table = io::text_of(effects_table(effects));
  EXPECT_NE(table.find("+2.00 [-0.48, +4.48]"), std::string::npos) << table;
  EXPECT_NE(effects_csv(effects).find("\na.robots,5,,,3,2.0000,-0.4841,4.4841,"), std::string::npos)
      << effects_csv(effects);
}

}  // namespace
}  // namespace autoref::experiments
