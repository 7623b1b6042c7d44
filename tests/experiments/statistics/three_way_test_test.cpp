#include "experiments/statistics/sequential_test.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

const SequentialTest kHalfAGoal = {.d0 = 0, .d1 = 0.5, .max_pairs = 400};

std::vector<double> pairs_with_mean(double mean, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<double> pairs;
  pairs.reserve(static_cast<std::size_t>(kHalfAGoal.max_pairs));
  for (int i = 0; i < kHalfAGoal.max_pairs; ++i) pairs.push_back(mean + 2 * random.normal());
  return pairs;
}

// The proportion of tests with this outcome.
double share_of(ThreeWayVerdict verdict, double mean) {
  constexpr int kTests = 400;
  int count = 0;
  for (std::uint64_t seed = 1; seed <= kTests; ++seed) {
    count += compared(kHalfAGoal, pairs_with_mean(mean, seed)).verdict == verdict ? 1 : 0;
  }
  return static_cast<double>(count) / kTests;
}

TEST(ThreeWayTest, FindsAGainAndALossOfDelta) {
  EXPECT_GT(share_of(ThreeWayVerdict::kBetter, 0.5), 0.9);
  EXPECT_GT(share_of(ThreeWayVerdict::kWorse, -0.5), 0.9);
}

// Alpha and beta are 0.05; four standard errors of 400 tests are 0.044.
TEST(ThreeWayTest, ClaimsNoGainAndNoLossIfThereIsNone) {
  EXPECT_LT(share_of(ThreeWayVerdict::kBetter, 0), 0.094);
  EXPECT_LT(share_of(ThreeWayVerdict::kWorse, 0), 0.094);
  EXPECT_GT(share_of(ThreeWayVerdict::kNotShown, 0), 0.8);
}

TEST(ThreeWayTest, NeverCallsALossBetter) {
  EXPECT_EQ(share_of(ThreeWayVerdict::kBetter, -0.5), 0);
}

TEST(ThreeWayTest, DoesNotDependOnPairsAfterTheDecision) {
  std::vector<double> pairs = pairs_with_mean(1, 3);
  const ThreeWayState state = compared(kHalfAGoal, pairs);
  ASSERT_EQ(state.verdict, ThreeWayVerdict::kBetter);
  pairs.resize(static_cast<std::size_t>(state.pairs));
  EXPECT_EQ(compared(kHalfAGoal, pairs).verdict, ThreeWayVerdict::kBetter);
  pairs.pop_back();
  EXPECT_EQ(compared(kHalfAGoal, pairs).verdict, ThreeWayVerdict::kGoOn);
}

TEST(ThreeWayTest, EndsUndecidedAfterTheLastPair) {
  SequentialTest test = kHalfAGoal;
  test.max_pairs = 11;
  const std::vector<double> pairs = pairs_with_mean(0.25, 1);
  EXPECT_EQ(compared(test, {pairs.data(), 11}).verdict, ThreeWayVerdict::kUndecided);
}

}  // namespace
}  // namespace autoref::experiments
