#include "experiments/statistics/anytime_interval.hpp"

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "experiments/statistics/interval.hpp"
#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

constexpr int kLongest = 200;

std::vector<double> normal_values(std::uint64_t seed, double mean) {
  RandomStream random(seed);
  std::vector<double> values;
  values.reserve(kLongest);
  for (int i = 0; i < kLongest; ++i) values.push_back(mean + 2 * random.normal());
  return values;
}

using IntervalOf = std::optional<Interval> (*)(std::span<const double>);

// The proportion of experiments in which some interval along the way misses the mean.
double share_of_missing(IntervalOf interval_of) {
  constexpr int kExperiments = 400;
  int missing = 0;
  for (std::uint64_t seed = 1; seed <= kExperiments; ++seed) {
    const std::vector<double> values = normal_values(seed, 1);
    bool is_missed = false;
    for (std::size_t n = 2; n <= values.size() && !is_missed; ++n) {
      const auto interval = interval_of({values.data(), n});
      is_missed = interval && (interval->low > 1 || interval->high < 1);
    }
    missing += is_missed ? 1 : 0;
  }
  return static_cast<double>(missing) / kExperiments;
}

TEST(AnytimeInterval, ContainsTheMeanAtAllTimesInNinetyFivePercentOfExperiments) {
  EXPECT_LE(
      share_of_missing([](std::span<const double> values) { return anytime_interval(values); }),
      0.05);
}

// Otherwise the test above would not show anything.
TEST(AnytimeInterval, IsNeededSinceStudentsMissesFarMoreOften) {
  EXPECT_GT(share_of_missing(mean_interval), 0.3);
}

TEST(AnytimeInterval, IsWiderThanStudentsButNotTwiceAsWide) {
  const std::vector<double> values = normal_values(1, 0);
  const Interval anytime = anytime_interval(values).value();
  const Interval student = mean_interval(values).value();
  const double ratio = (anytime.high - anytime.low) / (student.high - student.low);
  EXPECT_GT(ratio, 1.2);
  EXPECT_LT(ratio, 2);
}

TEST(AnytimeInterval, IsUnknownForFewOrEqualValues) {
  EXPECT_FALSE(anytime_interval(std::vector<double>{1}));
  EXPECT_FALSE(anytime_interval(std::vector<double>{1, 1, 1, 1}));
}

TEST(AnytimeInterval, AssumesTheLeastDeviation) {
  const std::vector<double> equal(20, 1);
  const Interval interval = anytime_interval(equal, 0.5).value();
  EXPECT_LT(interval.low, 1);
  EXPECT_GT(interval.high, 1);
  const std::vector<double> values = normal_values(1, 0);
  EXPECT_EQ(anytime_interval(values, 0.5)->low, anytime_interval(values)->low);
}

ComparisonState after(const ComparisonTest& test, std::uint64_t seed, double mean) {
  return decided_by(test, normal_values(seed, mean));
}

// The proportion of comparisons with this verdict. The spread is two goals.
double share_with(ThreeWayVerdict verdict, double mean) {
  constexpr int kExperiments = 400;
  const ComparisonTest test{.least = 1, .max_pairs = kLongest};
  int count = 0;
  for (std::uint64_t seed = 1; seed <= kExperiments; ++seed)
    count += after(test, seed, mean).verdict == verdict ? 1 : 0;
  return static_cast<double>(count) / kExperiments;
}

TEST(ComparisonByInterval, SeldomFindsADifferenceWhereThereIsNone) {
  EXPECT_LE(share_with(ThreeWayVerdict::kBetter, 0) + share_with(ThreeWayVerdict::kWorse, 0), 0.05);
  EXPECT_GE(share_with(ThreeWayVerdict::kNotShown, 0), 0.9);
}

TEST(ComparisonByInterval, FindsTheLeastDifferenceThatMatters) {
  EXPECT_GE(share_with(ThreeWayVerdict::kBetter, 1), 0.9);
  EXPECT_GE(share_with(ThreeWayVerdict::kWorse, -1), 0.9);
  EXPECT_LE(share_with(ThreeWayVerdict::kNotShown, 1), 0.025);
}

TEST(ComparisonByInterval, AgreesWithItsIntervalAndItsPValue) {
  const ComparisonTest test{.least = 1, .max_pairs = kLongest};
  for (const double mean : {-2.0, -0.5, 0.0, 0.5, 2.0}) {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      const ComparisonState state = after(test, seed, mean);
      ASSERT_TRUE(state.interval);
      const bool excludes_zero = state.interval->low > 0 || state.interval->high < 0;
      EXPECT_EQ(state.p < 0.05, excludes_zero);
      EXPECT_EQ(state.verdict == ThreeWayVerdict::kBetter, state.interval->low > 0);
      EXPECT_EQ(state.verdict == ThreeWayVerdict::kWorse, state.interval->high < 0);
      // The interval has the given mean and the spread of the values considered.
      const std::vector<double> values = normal_values(seed, mean);
      const std::span<const double> used(values.data(), static_cast<std::size_t>(state.pairs));
      EXPECT_NEAR(anytime_interval(used, least_deviation(test))->low, state.interval->low, 1e-9);
    }
  }
}

TEST(ComparisonByInterval, DecidesEvenIfAllPairsAreEqual) {
  const ComparisonTest test{.least = 0.3, .max_pairs = 300};
  const ComparisonState always = decided_by(test, std::vector<double>(300, 10));
  EXPECT_EQ(always.verdict, ThreeWayVerdict::kBetter);
  EXPECT_LT(always.pairs, 12);
  // Goalless pairs prove that no difference matters only after a while.
  const ComparisonState never = decided_by(test, std::vector<double>(300, 0));
  EXPECT_EQ(never.verdict, ThreeWayVerdict::kNotShown);
  EXPECT_GT(never.pairs, 20);
}

// With about that many pairs of the same mean and spread, the interval decides. (After an odd
// number of values, their mean is a little higher.)
TEST(ComparisonByInterval, EstimatesHowManyPairsWouldDecide) {
  const ComparisonTest test{.least = 1, .max_pairs = 30};
  std::vector<double> values;
  for (int i = 0; i < 15; ++i) values.insert(values.end(), {2.5, -1.5});  // mean 0.5
  const ComparisonState state = decided_by(test, values);
  ASSERT_EQ(state.verdict, ThreeWayVerdict::kUndecided);
  const int pairs = pairs_to_decide(test, state).value();
  EXPECT_GT(pairs, 30);
  for (int i = 0; i < 100; ++i) values.insert(values.end(), {2.5, -1.5});
  EXPECT_NEAR(decided_by(ComparisonTest{.least = 1, .max_pairs = 230}, values).pairs, pairs, 15);
  EXPECT_FALSE(pairs_to_decide(test, decided_by(test, {values.data(), 5})));
}

TEST(AnytimeP, IsBelowFivePercentExactlyIfTheIntervalExcludesZero) {
  RandomStream random(5);
  int excluded = 0;
  for (int i = 0; i < 200; ++i) {
    std::vector<double> values;
    for (int n = 0; n < 40; ++n) values.push_back(0.5 + random.normal());
    const Interval interval = anytime_interval(values).value();
    const bool excludes = interval.low > 0 || interval.high < 0;
    excluded += excludes ? 1 : 0;
    EXPECT_EQ(anytime_p(values) < 0.05, excludes);
  }
  EXPECT_GT(excluded, 20);
  EXPECT_LT(excluded, 180);
}

TEST(AnytimeP, IsThatOfAComparison) {
  const std::vector<double> values = {1, 0, 2, -1, 0, 1, 1, 0, 0, 2, -1};
  const ComparisonTest test{.least = 0.01, .max_pairs = 100};
  EXPECT_DOUBLE_EQ(anytime_p(values, least_deviation(test)), decided_by(test, values).p);
}

TEST(AnytimeP, IsOneWithoutSpread) {
  EXPECT_EQ(anytime_p(std::vector<double>{}), 1);
  EXPECT_EQ(anytime_p(std::vector<double>{2}), 1);
  EXPECT_EQ(anytime_p(std::vector<double>{2, 2, 2}), 1);
}

}  // namespace
}  // namespace autoref::experiments
