// Expected values from statsmodels 0.13, with effect = delta / (sd / sqrt(2)): pairs are
// ceil(TTestPower().solve_power(effect_size=effect, power=power, alpha=alpha)), and the power of n
// pairs is TTestPower().power(effect, n, alpha).
#include "experiments/statistics/sample_size.hpp"

#include <gtest/gtest.h>

namespace autoref::experiments {
namespace {

TEST(PowerOf, MatchesStatsmodels) {
  EXPECT_NEAR(power_of({0.5, 2}, 65), 0.8016316375345813, 1e-9);
  EXPECT_NEAR(power_of({0.25, 3}, 759), 0.9002037675798475, 1e-9);
  EXPECT_NEAR(power_of({2, 1, 0.01}, 6), 0.9694026225833066, 1e-9);
}

TEST(PowerOf, IsTheSameForADifferenceToEitherSide) {
  EXPECT_EQ(power_of({-0.5, 2}, 65), power_of({0.5, 2}, 65));
}

TEST(GamesNeeded, AreTwiceStatsmodelsPairs) {
  EXPECT_EQ(games_needed({0.5, 2}, 0.8), 130);
  EXPECT_EQ(games_needed({1, 2}, 0.8), 36);
  EXPECT_EQ(games_needed({0.25, 3}, 0.9), 1518);
  EXPECT_EQ(games_needed({2, 1, 0.01}, 0.95), 12);
  EXPECT_EQ(games_needed({0.5, 2}, 0.95), 212);
}

TEST(GamesNeeded, AreTwoPairsForAnyLargeDifference) {
  EXPECT_EQ(games_needed({100, 0.001}, 0.8), 4);
  EXPECT_EQ(games_needed({1e300, 1e-300}, 0.999), 4);
}

TEST(GamesNeeded, AreEmptyAboveTheLimit) {
  EXPECT_EQ(games_needed({0.004, 1}, 0.8), 490558);
  EXPECT_FALSE(games_needed({0.002, 1}, 0.8));
  EXPECT_FALSE(games_needed({1e-300, 1}, 0.8));
}

}  // namespace
}  // namespace autoref::experiments
