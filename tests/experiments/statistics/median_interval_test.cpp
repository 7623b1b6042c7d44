// Expected ranks: sums of binomial coefficients, as in tables of the sign test.
#include "experiments/statistics/interval.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace autoref::experiments {
namespace {

// The ranks of the interval's ends in a sample of this size.
std::optional<Interval> ranks(int size) {
  std::vector<double> sample(static_cast<std::size_t>(size));
  std::iota(sample.rbegin(), sample.rend(), 1.0);
  return median_interval(sample);
}

TEST(MedianInterval, NeedsSixValues) {
  EXPECT_FALSE(ranks(0));
  EXPECT_FALSE(ranks(5));  // all five on one side: 2 / 32 > 0.05
  EXPECT_TRUE(ranks(6));   // 2 / 64 < 0.05
}

TEST(MedianInterval, LiesBetweenTheRanksOfTheSignTest) {
  struct Ranks {
    int size, low, high;
  };
  for (const Ranks& expected : {Ranks{6, 1, 6}, Ranks{8, 1, 8}, Ranks{9, 2, 8}, Ranks{12, 3, 10},
                                Ranks{20, 6, 15}, Ranks{25, 8, 18}}) {
    const std::optional<Interval> interval = ranks(expected.size);
    ASSERT_TRUE(interval) << expected.size;
    EXPECT_EQ(interval->low, expected.low) << expected.size;
    EXPECT_EQ(interval->high, expected.high) << expected.size;
  }
}

TEST(MedianInterval, IgnoresOutliers) {
  const std::optional<Interval> interval =
      median_interval({1.01, 9.0, 0.99, 1.0, 1.02, 0.98, 1.0, 1.01, 0.1, 1.0, 1.0, 0.99});
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->low, 0.99);
  EXPECT_EQ(interval->high, 1.01);
}

}  // namespace
}  // namespace autoref::experiments
