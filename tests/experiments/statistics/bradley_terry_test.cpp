#include "experiments/statistics/penalised_likelihood.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/statistics/rating_examples.hpp"

namespace autoref::experiments {
namespace {

// The expected strengths come from an independent maximisation in Python: in an orthonormal basis Z
// of strengths that sum to zero, (w * logp + (n - w) * logq).sum() + numpy.linalg.slogdet(Z.T @ (n
// * p * q * Z.T).T)[1] / 2, with scipy.optimize.minimize(method = 'BFGS') and then Newton steps
// with numerical derivatives (NumPy 1.24, SciPy 1.10).

TEST(BradleyTerry, MaximisesFirthsPenalisedLikelihood) {
  expect_near_rating(bradley_terry(3, kThree), {0.82402605, -0.47532911, -0.34869695});
}

TEST(BradleyTerry, DoesSoInARoundRobinWithTeamsThatAlwaysWinOrLose) {
  expect_near_rating(bradley_terry(8, reference_round_robin()),
                     {-0.28934096, -5.26813740, 8.11466431, 3.29133888, -9.66241456, 1.00524911,
                      2.30233212, 0.50630849});
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

TEST(BradleyTerry, AddsHalfAWinToEachOfTwoTeams) {
  const double half = std::log((7.5 + 0.5) / (2.5 + 0.5)) / 2;
  expect_near_rating(
      bradley_terry(
          2, std::vector<MatchupTotals>{{.a = 1, .b = 0, .games = 10, .wins = 7.5, .draws = 3}}),
      {-half, half});
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

// Groups do not influence each other.
TEST(BradleyTerry, CentresUnlinkedGroupsOfTeamsAtZero) {
  std::vector<MatchupTotals> totals = kThree;
  totals.push_back({.a = 3, .b = 4, .games = 40, .wins = 40});
  const double half = std::log(40.5 / 0.5) / 2;
  expect_near_rating(bradley_terry(6, totals),
                     {0.82402605, -0.47532911, -0.34869695, half, -half, 0});
}

TEST(BradleyTerry, RatesTeamsWithoutGamesEqual) {
  expect_near_rating(bradley_terry(2, std::vector<MatchupTotals>{{0, 1}}), {0, 0});
  expect_near_rating(bradley_terry(2, {}), {0, 0});
}

}  // namespace
}  // namespace autoref::experiments
