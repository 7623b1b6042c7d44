#include "logs/fit/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

std::optional<double> mean_of(const std::vector<double>& values,
                              std::span<const std::size_t> groups) {
  double sum = 0;
  for (const std::size_t i : groups) sum += values[i];
  return sum / static_cast<double>(groups.size());
}

std::vector<double> normal_values(std::size_t count, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<double> values(count);
  for (double& value : values) value = 10 + 2 * random.normal();
  return values;
}

TEST(Bootstrap, IntervalOfAMeanIsThatOfTheNormalDistribution) {
  const std::vector<double> values = normal_values(400, 1);
  const auto mean = bootstrap_estimate(
      values.size(), 1, 0, [&](auto groups) { return mean_of(values, groups); }, 2000);
  ASSERT_TRUE(mean);
  const double half = 1.96 * 2 / std::sqrt(400.0);
  EXPECT_NEAR(mean->value, 10, 3 * half);
  EXPECT_NEAR(mean->value - mean->low, half, half / 6);
  EXPECT_NEAR(mean->high - mean->value, half, half / 6);
}

TEST(Bootstrap, IntervalCoversTheTruthInMostSamples) {
  int covered = 0;
  constexpr int kSamples = 200;
  for (int sample = 0; sample < kSamples; ++sample) {
    const std::vector<double> values = normal_values(50, 100 + static_cast<std::uint64_t>(sample));
    const auto mean = bootstrap_estimate(values.size(), 1, 0,
                                         [&](auto groups) { return mean_of(values, groups); });
    ASSERT_TRUE(mean);
    covered += mean->low <= 10 && 10 <= mean->high;
  }
  EXPECT_GE(covered, kSamples * 88 / 100);
  EXPECT_LE(covered, kSamples * 99 / 100);
}

TEST(Bootstrap, SystematicErrorWidensTheInterval) {
  const std::vector<double> values(20, 5.0);
  const auto mean = bootstrap_estimate(values.size(), 1, 0.1,
                                       [&](auto groups) { return mean_of(values, groups); });
  ASSERT_TRUE(mean);
  EXPECT_DOUBLE_EQ(mean->low, 4.5);
  EXPECT_DOUBLE_EQ(mean->high, 5.5);
}

TEST(Bootstrap, NeedsEnoughGroups) {
  const std::vector<double> values(3, 5.0);
  const auto estimator = [&](auto groups) { return mean_of(values, groups); };
  EXPECT_FALSE(bootstrap_estimate(3, 4, 0, estimator));
  EXPECT_TRUE(bootstrap_estimate(3, 3, 0, estimator));
  EXPECT_FALSE(bootstrap_estimate(0, 0, 0, estimator));
}

TEST(Bootstrap, FailsIfManyDrawsShowTooLittle) {
  // Without group 0, nothing is known: more than a third of the draws lack it.
  const auto estimator = [](std::span<const std::size_t> groups) -> std::optional<double> {
    if (std::find(groups.begin(), groups.end(), 0) == groups.end()) return std::nullopt;
    return 1.0;
  };
  EXPECT_FALSE(bootstrap_estimate(10, 1, 0, estimator));
}

TEST(WeightedMedian, CountsWeights) {
  const std::vector<double> values{3, 1, 2};
  EXPECT_EQ(weighted_median(values, std::vector<double>{1, 1, 1}), 2);
  EXPECT_EQ(weighted_median(values, std::vector<double>{5, 1, 1}), 3);
  EXPECT_EQ(weighted_median(values, std::vector<double>{1, 5, 1}), 1);
}

TEST(Quantile, InterpolatesBetweenValues) {
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_DOUBLE_EQ(quantile({7}, 0.3), 7);
}

TEST(RobustMean, IgnoresValuesFarOff) {
  std::vector<Measured> values;
  for (const double value : normal_values(200, 7)) values.push_back({value, 2});
  for (int i = 0; i < 20; ++i) values.push_back({40, 2});
  EXPECT_NEAR(robust_mean(values, 0), 10, 0.5);
}

}  // namespace
}  // namespace autoref::logs
