#include "experiments/scenes/distribution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "experiments/statistics/sample.hpp"

namespace autoref::experiments {
namespace {

constexpr Range kWide{-100, 100};

std::vector<double> many_from(const Distribution& distribution, const Range& range = kWide) {
  std::vector<double> values;
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    RandomStream random(seed);
    values.push_back(drawn(distribution, range, random));
  }
  return values;
}

double lowest(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}
double highest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

TEST(Distribution, OfANumberIsThatNumber) {
  RandomStream random(1);
  EXPECT_EQ(drawn(1.5, kWide, random), 1.5);
}

TEST(Distribution, OfTwoEndsIsUniform) {
  const std::vector<double> values = many_from(Distribution::uniform(1, 3));
  EXPECT_GE(lowest(values), 1);
  EXPECT_LT(lowest(values), 1.01);
  EXPECT_LE(highest(values), 3);
  EXPECT_GT(highest(values), 2.99);
  EXPECT_NEAR(mean(values), 2, 0.05);
  EXPECT_NEAR(*standard_deviation(values), 2 / std::sqrt(12.0), 0.02);
}

TEST(Distribution, OfAMeanIsNormalWithinThreeDeviations) {
  const std::vector<double> values = many_from(Distribution::normal(2, 0.5));
  EXPECT_NEAR(mean(values), 2, 0.04);
  EXPECT_NEAR(*standard_deviation(values), 0.5, 0.03);
  EXPECT_GE(lowest(values), 0.5);
  EXPECT_LE(highest(values), 3.5);
}

TEST(Distribution, IsCutOffAtTheEndsOfItsRange) {
  const std::vector<double> values = many_from(Distribution::normal(2, 0.5), {1.8, 2.0});
  EXPECT_GE(lowest(values), 1.8);
  EXPECT_LE(highest(values), 2.0);
  EXPECT_GT(*standard_deviation(values), 0.01);
}

}  // namespace
}  // namespace autoref::experiments
