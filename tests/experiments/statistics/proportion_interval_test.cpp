// Expected values from SciPy 1.10: scipy.stats.binomtest(successes, n).proportion_ci(0.95, method)
// with method 'wilson' or 'exact'.
#include "experiments/statistics/interval.hpp"

#include <gtest/gtest.h>

namespace autoref::experiments {
namespace {

void expect_near(const std::optional<Interval>& interval, double low, double high) {
  ASSERT_TRUE(interval);
  EXPECT_NEAR(interval->low, low, 1e-10);
  EXPECT_NEAR(interval->high, high, 1e-10);
}

TEST(WilsonInterval, MatchesSciPy) {
  expect_near(wilson_interval(15, 20), 0.5312991223812561, 0.8881382985923344);
  expect_near(wilson_interval(3, 60), 0.017149502164395668, 0.13700516476348518);
}

TEST(WilsonInterval, ReachesTheEndIfNothingOrEverythingSucceeded) {
  EXPECT_EQ(wilson_interval(0, 20).value().low, 0.0);
  EXPECT_EQ(wilson_interval(20, 20).value().high, 1.0);
  EXPECT_NEAR(wilson_interval(0, 20).value().high, 0.16112515805281935, 1e-10);
}

TEST(ClopperPearsonInterval, MatchesSciPy) {
  expect_near(clopper_pearson_interval(15, 20), 0.5089541282920425, 0.9134285308985655);
  expect_near(clopper_pearson_interval(3, 60), 0.01043232964434822, 0.13924324672110006);
  expect_near(clopper_pearson_interval(0, 20), 0, 0.16843347098308548);
  expect_near(clopper_pearson_interval(20, 20), 0.8315665290169145, 1);
}

TEST(ProportionInterval, IsWilsonsIfSomeSucceeded) {
  expect_near(proportion_interval(15, 20), 0.5312991223812561, 0.8881382985923344);
}

TEST(ProportionInterval, IsTheExactOneIfNothingOrEverythingSucceeded) {
  expect_near(proportion_interval(0, 20), 0, 0.16843347098308548);
  expect_near(proportion_interval(20, 20), 0.8315665290169145, 1);
}

TEST(ProportionInterval, NeedsATrial) {
  EXPECT_FALSE(wilson_interval(0, 0));
  EXPECT_FALSE(clopper_pearson_interval(0, 0));
  EXPECT_FALSE(proportion_interval(0, 0));
}

}  // namespace
}  // namespace autoref::experiments
