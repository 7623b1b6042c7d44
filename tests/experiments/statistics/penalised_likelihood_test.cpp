#include "experiments/statistics/penalised_likelihood.hpp"

#include <gtest/gtest.h>

#include "tests/experiments/statistics/rating_examples.hpp"

namespace autoref::experiments {
namespace {

TEST(PenalisedLikelihood, HasTheDerivativesThatItStates) {
  const PenalisedLikelihood likelihood(3, kThree);
  const Eigen::Vector3d strengths(0.9, 0.2, -1.1);
  const Eigen::Vector3d direction = likelihood.direction_of(1);
  const double h = 1e-5;
  const double slope = (likelihood.at(strengths + h * direction).value -
                        likelihood.at(strengths - h * direction).value) /
                       (2 * h);
  EXPECT_NEAR(likelihood.at(strengths).score.dot(direction), slope, 1e-8);
}

// Steps of any length led to where all results of team 3 are certain, and stayed there.
TEST(PenalisedLikelihood, IsMaximisedIfAlmostNoResultIsInDoubt) {
  const PenalisedLikelihood likelihood(
      9, std::vector<MatchupTotals>{
             {0, 2, 2, 0, 0},    {0, 3, 88, 0, 0},    {0, 4, 132, 0, 0}, {0, 7, 10, 0, 0},
             {1, 2, 124, 0, 0},  {1, 3, 23, 0, 0},    {1, 5, 1, 0, 0},   {1, 7, 14, 0, 0},
             {1, 8, 27, 0, 0},   {2, 3, 2, 0, 0},     {2, 6, 1, 0, 1},   {2, 8, 388, 0, 388},
             {3, 5, 3, 0, 3},    {3, 6, 45, 0, 45},   {4, 5, 98, 0, 90}, {4, 7, 49, 0, 27},
             {4, 8, 5094, 0, 0}, {5, 6, 125, 0, 123}, {5, 7, 22, 0, 4},  {5, 8, 15, 0, 0},
             {6, 7, 71, 0, 0},   {6, 8, 98, 0, 0},    {7, 8, 1, 0, 0}});
  EXPECT_LT(likelihood.maximum().score.cwiseAbs().maxCoeff(), 1e-4);
}

TEST(ShortenedStep, ChangesNoStrengthByMoreThanTwo) {
  EXPECT_EQ(shortened_step(Eigen::Vector2d(-8, 4)), Eigen::Vector2d(-2, 1));
  EXPECT_EQ(shortened_step(Eigen::Vector2d(-1.5, 1)), Eigen::Vector2d(-1.5, 1));
}

}  // namespace
}  // namespace autoref::experiments
