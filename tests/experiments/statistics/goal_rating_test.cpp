#include "experiments/statistics/penalised_likelihood.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/statistics/rating_examples.hpp"

namespace autoref::experiments {
namespace {

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

}  // namespace
}  // namespace autoref::experiments
