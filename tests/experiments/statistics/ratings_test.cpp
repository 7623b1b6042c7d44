#include "experiments/statistics/ratings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace autoref::experiments {
namespace {

// Games of a against b, one leg per difference.
RatedMatchup matchup_of(const std::string& a, const std::string& b,
                        const std::vector<std::vector<double>>& pairs) {
  RatedMatchup matchup{a, b, {}};
  int number = 0;
  for (const std::vector<double>& differences : pairs) {
    ++number;
    for (const double difference : differences) {
      const double win = difference > 0 ? 1 : difference < 0 ? 0 : 0.5;
      matchup.pairs[number].push_back({difference, win});
    }
  }
  return matchup;
}

const std::vector<RatedMatchup> kRoundRobin = {
    matchup_of("plain", "bold", {{1, 0}, {3, -1}, {-2, 0}, {0, 0}, {2, 2}}),
    matchup_of("plain", "zone", {{2, 1}, {0, -1}, {1}, {-2, 1}, {0, 3}}),
    matchup_of("bold", "zone", {{-1, -1}, {4, 2}, {0, 1}, {1, 1}, {-3, 0}})};

TEST(RatingsOf, AreSortedByTeamName) {
  const std::vector<Rating> ratings = goal_ratings_of(
      {matchup_of("plain", "bold", {{1, 3}}), matchup_of("zone", "bold", {{0, 4}})});
  ASSERT_EQ(ratings.size(), 3);
  EXPECT_EQ(ratings[0].team, "bold");
  EXPECT_NEAR(ratings[0].value, -4.0 / 3, 1e-12);
  EXPECT_EQ(ratings[2].team, "zone");
  EXPECT_NEAR(ratings[2].value, 2.0 / 3, 1e-12);
}

TEST(RatingsOf, DoNotDependOnTheOrderOfRows) {
  std::vector<RatedMatchup> turned(kRoundRobin.rbegin(), kRoundRobin.rend());
  for (RatedMatchup& matchup : turned) {
    for (auto& [pair, games] : matchup.pairs) std::reverse(games.begin(), games.end());
  }
  for (const auto rate : {goal_ratings_of, bradley_terry_ratings_of}) {
    const std::vector<Rating> ratings = rate(kRoundRobin);
    const std::vector<Rating> again = rate(turned);
    for (std::size_t i = 0; i < ratings.size(); ++i) {
      EXPECT_EQ(ratings[i].value, again[i].value);
      EXPECT_EQ(ratings[i].interval.value().low, again[i].interval.value().low);
      EXPECT_EQ(ratings[i].interval.value().high, again[i].interval.value().high);
    }
  }
}

const std::vector<std::vector<double>> kTwentyPairs = {
    {3, 1}, {0, -2}, {1, 1}, {2, 0},   {-1, 0}, {4, 2}, {0, 1},  {-3, 1}, {2, 2},  {1, 0},
    {0, 0}, {5, -1}, {1, 2}, {-2, -1}, {3, 0},  {0, 2}, {1, -1}, {2, 3},  {-1, 1}, {0, 4}};

// SciPy 1.10, with x the means of the twenty pairs: half of scipy.stats.bootstrap((x,), numpy.mean,
// n_resamples=200000, method='percentile').confidence_interval. A thousand resamples agree within
// 0.03.
TEST(GoalRatingsOf, MatchSciPysBootstrapInterval) {
  const Rating rating = goal_ratings_of({matchup_of("a", "b", kTwentyPairs)}).front();
  EXPECT_NEAR(rating.value, 0.4125, 1e-12);
  EXPECT_NEAR(rating.interval.value().low, 0.275 / 2, 0.03);
  EXPECT_NEAR(rating.interval.value().high, 1.35 / 2, 0.03);
}

// Drawing legs separately would spread the ratings.
TEST(GoalRatingsOf, KeepTheLegsOfAPairTogether) {
  const std::vector<Rating> ratings = goal_ratings_of(
      {matchup_of("a", "b", {{3, -3}, {-3, 3}, {2, -2}, {1, -1}, {4, -4}, {0.5, -0.4}})});
  EXPECT_NEAR(ratings[0].interval.value().low, 0, 0.02);
  EXPECT_NEAR(ratings[0].interval.value().high, 0, 0.02);
}

TEST(GoalRatingsOf, HaveNoIntervalBelowFivePairsInAMatchup) {
  const std::vector<std::vector<double>> few = {{1, 2}, {0, 0}, {3, 1}, {0, 2}};
  std::vector<std::vector<double>> enough = few;
  enough.push_back({1, 1});
  EXPECT_FALSE(
      goal_ratings_of({matchup_of("a", "b", enough), matchup_of("a", "c", few)}).front().interval);
  EXPECT_TRUE(goal_ratings_of({matchup_of("a", "b", enough), matchup_of("a", "c", enough)})
                  .front()
                  .interval);
}

TEST(GoalRatingsOf, HaveNoIntervalIfAllPairsAreTheSame) {
  const std::vector<std::vector<double>> same(10, {-6, -6});
  EXPECT_FALSE(goal_ratings_of({matchup_of("a", "b", same)}).front().interval);
}

// The same totals as in strength_profile_test.cpp, with one drawn game between "b" and "c".
TEST(BradleyTerryRatingsOf, HaveTheIntervalsOfTheProfile) {
  const std::vector<Rating> ratings = bradley_terry_ratings_of(
      {matchup_of("a", "b", {{1, 1}, {2, -1}}), matchup_of("a", "c", {{4, 1}}),
       matchup_of("b", "c", {{1, -3}, {0, -2}})});
  ASSERT_EQ(ratings.size(), 3);
  EXPECT_NEAR(ratings[0].value, 0.82402605, 5e-9);
  EXPECT_NEAR(ratings[0].interval.value().low, -0.178617, 1e-6);
  EXPECT_NEAR(ratings[0].interval.value().high, 2.213977, 1e-6);
}

TEST(BradleyTerryRatingsOf, HaveAnIntervalAfterASingleGame) {
  EXPECT_TRUE(bradley_terry_ratings_of({matchup_of("a", "b", {{1}})}).front().interval);
  EXPECT_FALSE(bradley_terry_ratings_of({matchup_of("a", "b", {})}).front().interval);
}

TEST(RatingsOf, LeaveOutAMatchupWithoutGames) {
  const std::vector<std::vector<double>> pairs = {{1, 1}, {1, 1}, {2, 0}, {0, 1}, {1, 2}};
  const std::vector<Rating> ratings =
      goal_ratings_of({matchup_of("a", "b", pairs), matchup_of("a", "c", {})});
  EXPECT_NEAR(ratings[0].value, 0.5, 1e-12);
  EXPECT_NEAR(ratings[2].value, 0, 1e-12);
  EXPECT_TRUE(ratings[0].interval);
}

TEST(RatingsOf, AreEmptyWithoutTeams) {
  EXPECT_TRUE(goal_ratings_of({}).empty());
  EXPECT_TRUE(bradley_terry_ratings_of({}).empty());
}

// Every iteration on the way is bounded, and the matrices are factored once per iteration.
TEST(BradleyTerryRatingsOf, HaveAllIntervalsInALargeField) {
  std::vector<RatedMatchup> matchups;
  for (int i = 0; i < 60; ++i) {
    for (int j = i + 1; j < 60; ++j) {
      const double result = (i * 7 + j * 11) % 3 - 1;
      matchups.push_back(matchup_of(std::to_string(i), std::to_string(j), {{result, 1}}));
    }
  }
  for (const Rating& rating : bradley_terry_ratings_of(matchups)) EXPECT_TRUE(rating.interval);
}

// NumPy 1.24: numpy.percentile([3, 1, 4, 1, 5, 9, 2, 6], [2.5, 50, 97.5]).
TEST(QuantileOf, MatchesNumPy) {
  const std::vector<double> sample = {3, 1, 4, 1, 5, 9, 2, 6};
  EXPECT_NEAR(quantile_of(sample, 0.025), 1.0, 1e-12);
  EXPECT_NEAR(quantile_of(sample, 0.5), 3.5, 1e-12);
  EXPECT_NEAR(quantile_of(sample, 0.975), 8.475, 1e-12);
}

TEST(QuantileOf, ReachesTheEnds) {
  EXPECT_EQ(quantile_of({2.0, 1.0}, 0), 1.0);
  EXPECT_EQ(quantile_of({2.0, 1.0}, 1), 2.0);
  EXPECT_EQ(quantile_of({7.0}, 0.3), 7.0);
}

}  // namespace
}  // namespace autoref::experiments
