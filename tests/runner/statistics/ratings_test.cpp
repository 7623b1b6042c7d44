#include "runner/statistics/ratings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "runner/statistics/bradley_terry.hpp"
#include "runner/statistics/goal_rating.hpp"

namespace autoref::runner {
namespace {

// Three teams, all against all: games, goal difference, wins of the first.
const std::vector<MatchupTotals> kThree = {
    {.a = 0, .b = 1, .games = 4, .difference = 3, .wins = 3},
    {.a = 0, .b = 2, .games = 2, .difference = 5, .wins = 2},
    {.a = 1, .b = 2, .games = 4, .difference = -2, .wins = 1.5}};

void expect_near_rating(const Eigen::VectorXd& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(found(i), expected[i], 5e-9) << i;
}

// NumPy 1.24, with one row of X per matchup (1, -1, 0; 1, 0, -1; 0, 1, -1), n games and d goals:
// numpy.linalg.lstsq(X * sqrt(n)[:, None], d / sqrt(n), rcond=None)[0].
TEST(GoalRating, MatchesNumPysLeastSquares) {
  expect_near_rating(goal_rating(3, kThree), {0.8958333333, -0.4166666667, -0.4791666667});
}

TEST(GoalRating, IsExactIfTheGamesAreConsistent) {
  expect_near_rating(
      goal_rating(
          3, std::vector<MatchupTotals>{{.a = 0, .b = 1, .games = 2, .difference = 2, .wins = 0},
                                        {.a = 2, .b = 1, .games = 4, .difference = 8, .wins = 0}}),
      {0, -1, 1});
}

TEST(GoalRating, CentresUnlinkedGroupsOfTeamsAtZero) {
  expect_near_rating(
      goal_rating(
          5, std::vector<MatchupTotals>{{.a = 0, .b = 1, .games = 2, .difference = 4, .wins = 2},
                                        {.a = 2, .b = 3, .games = 2, .difference = -12, .wins = 0},
                                        {.a = 0, .b = 4}}),
      {1, -1, -3, 3, 0});
}

// statsmodels 0.13, with w wins in n games plus one draw, Z = X[:, :2] with -1 for the last team:
// GLM(numpy.c_[w + 0.5, n + 0.5 - w], Z, family=Binomial()).fit(tol=1e-14).params.
TEST(BradleyTerry, MatchesStatsmodelsLogit) {
  expect_near_rating(bradley_terry(3, kThree), {0.72035287, -0.43819635, -0.28215651});
}

TEST(BradleyTerry, StaysFiniteIfATeamWinsEverything) {
  // For two teams, half the log odds with half a win added for each.
  const double half = std::log(40.5 / 0.5) / 2;
  expect_near_rating(
      bradley_terry(
          2,
          std::vector<MatchupTotals>{{.a = 0, .b = 1, .games = 40, .difference = 90, .wins = 40}}),
      {half, -half});
}

TEST(BradleyTerry, FollowsAChainOfTeamsThatAlwaysWin) {
  std::vector<MatchupTotals> chain;
  for (std::size_t i = 0; i < 9; ++i)
    chain.push_back({.a = i, .b = i + 1, .games = 1000, .difference = 3000, .wins = 1000});
  const Eigen::VectorXd strengths = bradley_terry(10, chain);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(strengths(i) - strengths(i + 1), std::log(1000.5 / 0.5), 1e-6);
  }
}

TEST(BradleyTerry, RatesTeamsWithoutGamesEqual) {
  expect_near_rating(bradley_terry(2, std::vector<MatchupTotals>{{0, 1}}), {0, 0});
  expect_near_rating(bradley_terry(2, {}), {0, 0});
}

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
  const std::vector<Rating> ratings = ratings_of(
      {matchup_of("plain", "bold", {{1, 3}}), matchup_of("zone", "bold", {{0, 4}})}, goal_rating);
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
  for (const RatingMethod& rate : {RatingMethod(goal_rating), RatingMethod(bradley_terry)}) {
    const std::vector<Rating> ratings = ratings_of(kRoundRobin, rate);
    const std::vector<Rating> again = ratings_of(turned, rate);
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
TEST(RatingsOf, MatchSciPysBootstrapInterval) {
  const Rating rating = ratings_of({matchup_of("a", "b", kTwentyPairs)}, goal_rating).front();
  EXPECT_NEAR(rating.value, 0.4125, 1e-12);
  EXPECT_NEAR(rating.interval.value().low, 0.275 / 2, 0.03);
  EXPECT_NEAR(rating.interval.value().high, 1.35 / 2, 0.03);
}

// Drawing legs separately would spread the ratings.
TEST(RatingsOf, KeepTheLegsOfAPairTogether) {
  const std::vector<Rating> ratings =
      ratings_of({matchup_of("a", "b", {{3, -3}, {-3, 3}, {2, -2}, {1, -1}, {4, -4}, {0.5, -0.4}})},
                 goal_rating);
  EXPECT_NEAR(ratings[0].interval.value().low, 0, 0.02);
  EXPECT_NEAR(ratings[0].interval.value().high, 0, 0.02);
}

TEST(RatingsOf, HaveNoIntervalBelowFivePairsInAMatchup) {
  const std::vector<std::vector<double>> few = {{1, 2}, {0, 0}, {3, 1}, {0, 2}};
  std::vector<std::vector<double>> enough = few;
  enough.push_back({1, 1});
  EXPECT_FALSE(ratings_of({matchup_of("a", "b", enough), matchup_of("a", "c", few)}, goal_rating)
                   .front()
                   .interval);
  EXPECT_TRUE(ratings_of({matchup_of("a", "b", enough), matchup_of("a", "c", enough)}, goal_rating)
                  .front()
                  .interval);
}

TEST(RatingsOf, HaveNoIntervalIfAllPairsAreTheSame) {
  const std::vector<std::vector<double>> same(10, {-6, -6});
  EXPECT_FALSE(ratings_of({matchup_of("a", "b", same)}, goal_rating).front().interval);
  EXPECT_FALSE(ratings_of({matchup_of("a", "b", same)}, bradley_terry).front().interval);
}

TEST(RatingsOf, LeaveOutAMatchupWithoutGames) {
  const std::vector<std::vector<double>> pairs = {{1, 1}, {1, 1}, {2, 0}, {0, 1}, {1, 2}};
  const std::vector<Rating> ratings =
      ratings_of({matchup_of("a", "b", pairs), matchup_of("a", "c", {})}, goal_rating);
  EXPECT_NEAR(ratings[0].value, 0.5, 1e-12);
  EXPECT_NEAR(ratings[2].value, 0, 1e-12);
  EXPECT_TRUE(ratings[0].interval);
}

TEST(RatingsOf, AreEmptyWithoutTeams) { EXPECT_TRUE(ratings_of({}, bradley_terry).empty()); }

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
}  // namespace autoref::runner
