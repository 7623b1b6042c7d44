#include "experiments/statistics/ratings.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/experiments/statistics/rating_examples.hpp"

namespace autoref::experiments {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<std::optional<Interval>> intervals_for(std::size_t teams,
                                                   const std::vector<MatchupTotals>& totals) {
  const PenalisedLikelihood likelihood(teams, totals);
  return profile_intervals(likelihood, likelihood.maximum());
}

void expect_near_interval(const std::optional<Interval>& found, const Interval& expected) {
  ASSERT_TRUE(found);
  if (std::isinf(expected.low)) {
    EXPECT_EQ(found->low, expected.low);
  } else {
    EXPECT_NEAR(found->low, expected.low, 2e-6);
  }
  if (std::isinf(expected.high)) {
    EXPECT_EQ(found->high, expected.high);
  } else {
    EXPECT_NEAR(found->high, expected.high, 2e-6);
  }
}

// The expected ends are from the likelihood of bradley_terry_test.cpp: scipy.optimize.brentq of the
// strength at which the maximum over all other strengths (method = 'BFGS') has dropped by
// dispersion * scipy.stats.chi2.ppf(0.95, 1) / 2.

TEST(StrengthProfile, MatchesARootSearchInTheProfile) {
  const std::vector<std::optional<Interval>> intervals = intervals_for(3, kThree);
  ASSERT_EQ(intervals.size(), 3);
  expect_near_interval(intervals[0], {-0.178617, 2.213977});
  expect_near_interval(intervals[1], {-1.470393, 0.368716});
  expect_near_interval(intervals[2], {-1.454239, 0.632988});
}

TEST(StrengthProfile, DoesSoInARoundRobinOfVeryUnequalTeams) {
  const std::vector<std::optional<Interval>> intervals = intervals_for(8, reference_round_robin());
  ASSERT_EQ(intervals.size(), 8);
  expect_near_interval(intervals[0], {-1.061502, 0.818754});
  expect_near_interval(intervals[1], {-8.336081, -3.817392});
  expect_near_interval(intervals[2], {6.388848, kInfinity});
  expect_near_interval(intervals[3], {2.493450, 4.417195});
  expect_near_interval(intervals[4], {-kInfinity, -7.424335});
  expect_near_interval(intervals[5], {0.242973, 2.109105});
  expect_near_interval(intervals[6], {1.529625, 3.412738});
  expect_near_interval(intervals[7], {-0.257534, 1.610720});
}

TEST(StrengthProfile, IsOpenForATeamThatLostNoPoint) {
  const std::vector<std::optional<Interval>> intervals =
      intervals_for(2, {{.a = 0, .b = 1, .games = 40, .wins = 40}});
  expect_near_interval(intervals.at(0), {1.224566, kInfinity});
  expect_near_interval(intervals.at(1), {-kInfinity, -1.224566});
}

TEST(StrengthProfile, IsClosedAfterASingleDraw) {
  const std::vector<std::optional<Interval>> intervals =
      intervals_for(2, {{.a = 0, .b = 1, .games = 40, .wins = 39.5, .draws = 1}});
  EXPECT_TRUE(std::isfinite(intervals.at(0).value().high));
  EXPECT_TRUE(std::isfinite(intervals.at(1).value().low));
}

TEST(StrengthProfile, ExistsAfterASingleGame) {
  expect_near_interval(intervals_for(2, {{.a = 0, .b = 1, .games = 1, .wins = 1}}).at(0),
                       {-0.916163, kInfinity});
}

TEST(StrengthProfile, IsMissingForATeamWithoutGames) {
  const std::vector<std::optional<Interval>> intervals =
      intervals_for(4, {{.a = 0, .b = 1, .games = 4, .wins = 2}, {.a = 0, .b = 2}});
  EXPECT_TRUE(intervals.at(0));
  EXPECT_FALSE(intervals.at(2));
  EXPECT_FALSE(intervals.at(3));
}

TEST(StrengthProfile, ExistsForEveryTeamInAChainThatIsFarApart) {
  std::vector<MatchupTotals> chain;
  for (std::size_t i = 0; i < 9; ++i) {
    chain.push_back({.a = i, .b = i + 1, .games = 1000, .wins = 1000});
  }
  for (const std::optional<Interval>& interval : intervals_for(10, chain)) EXPECT_TRUE(interval);
}

double dispersion_of(double games, double wins, double draws) {
  const PenalisedLikelihood likelihood(
      2,
      std::vector<MatchupTotals>{{.a = 0, .b = 1, .games = games, .wins = wins, .draws = draws}});
  return dispersion(likelihood, likelihood.maximum());
}

// Equal teams: a game's variance is 1/4 without draws, 0 if drawn.
TEST(Dispersion, IsTheShareOfDecidedGamesBetweenEqualTeams) {
  EXPECT_NEAR(dispersion_of(40, 20, 10), 0.75, 1e-12);
  EXPECT_NEAR(dispersion_of(40, 20, 0), 1, 1e-12);
}

TEST(Dispersion, IsAtLeastAHalf) { EXPECT_EQ(dispersion_of(40, 20, 40), 0.5); }

}  // namespace
}  // namespace autoref::experiments
