#include "tools/planted/measured_difference.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace autoref::tools {
namespace {

using Sample = std::vector<double>;

// Mean 0.5 and, with n - 1 in the denominator, standard deviation sqrt(2).
const Sample kGoals = {-0.5, 1.5};

Sample times(double factor, Sample sample) {
  for (double& value : sample) value *= factor;
  return sample;
}

// Forty pairs, all won: 1 and 2 alternately.
Sample clear_wins() {
  Sample sample;
  for (int i = 0; i < 20; ++i) sample.insert(sample.end(), {1, 2});
  return sample;
}

TEST(RelativeGames, AreAQuarterWithHalfTheSpread) {
  EXPECT_DOUBLE_EQ(relative_games(Sample{0, 1}, kGoals), 0.25);
}

TEST(RelativeGames, AreFourTimesAsManyWithHalfTheMean) {
  EXPECT_DOUBLE_EQ(relative_games(Sample{-0.75, 1.25}, kGoals), 4);
}

TEST(RelativeGames, DoNotDependOnTheUnit) {
  EXPECT_DOUBLE_EQ(relative_games(times(3, kGoals), kGoals), 1);
}

TEST(RelativeGames, AreTheMostIfTheMeasureFavoursTheOtherTeam) {
  EXPECT_EQ(relative_games(times(-1, kGoals), kGoals), kMostRelativeGames);
  EXPECT_EQ(relative_games(Sample{-1, 1}, kGoals), kMostRelativeGames);
}

TEST(RelativeGames, AreTheMostIfGoalsHaveNoSpread) {
  EXPECT_EQ(relative_games(Sample{0, 1}, Sample{1, 1}), kMostRelativeGames);
}

// docs/explanations/statistics.md: 130 games for 0.5 goals if the standard deviation of a game
// is 2.
TEST(MeasuredDifferences, GiveTheSampleSizeOfTheTTest) {
  EXPECT_EQ(measured_differences({{"goals", kGoals}}).front().games, 130);
}

TEST(MeasuredDifferences, HaveNoNumberOfGamesInFavourOfTheOtherTeam) {
  EXPECT_FALSE(measured_differences({{"goals", kGoals}, {"xG", times(-1, kGoals)}})[1].games);
}

TEST(MeasuredDifferences, AreComparedWithGoals) {
  const auto measured =
      measured_differences({{"goals", {0, 1, 2, 3}}, {"xG", {0.5, 1, 1.5, 2}}})[1];
  EXPECT_DOUBLE_EQ(measured.minus_goals, -0.25);
  EXPECT_DOUBLE_EQ(measured.correlation.value(), 1);
  EXPECT_DOUBLE_EQ(measured.relative_with_equal_means, 0.25);
}

TEST(MeasuredDifferences, HaveNoCorrelationWithoutSpread) {
  EXPECT_FALSE(measured_differences({{"goals", kGoals}, {"xG", {1, 1}}})[1].correlation);
}

TEST(OrderedDecisions, AreRightAfterClearWins) {
  const OrderedDecisions decisions =
      measured_differences({{"goals", clear_wins()}}).front().decisions;
  EXPECT_NEAR(decisions.right, 1, 1e-9);
  EXPECT_EQ(decisions.wrong, 0);
  // No comparison is decided before the tenth pair (experiments/statistics/anytime_interval.hpp).
  EXPECT_GE(decisions.median_games.value(), 20);
  EXPECT_LE(decisions.median_games.value(), 30);
}

TEST(OrderedDecisions, AreWrongIfTheMeasureFavoursTheOtherTeam) {
  const OrderedDecisions decisions =
      measured_differences({{"goals", clear_wins()}, {"xG", times(-1, clear_wins())}})[1].decisions;
  EXPECT_EQ(decisions.right, 0);
  EXPECT_NEAR(decisions.wrong, 1, 1e-9);
}

TEST(OrderedDecisions, HaveNoMedianIfMostEndUndecided) {
  const OrderedDecisions decisions = measured_differences({{"goals", kGoals}}).front().decisions;
  EXPECT_EQ(decisions.right + decisions.wrong, 0);
  EXPECT_FALSE(decisions.median_games);
}

}  // namespace
}  // namespace autoref::tools
