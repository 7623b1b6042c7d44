#include "experiments/tune/spsa.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/experiments/tune/noisy_search.hpp"

namespace autoref::experiments {
namespace {

constexpr int kSeeds = 40;  // that tests average over

Search spsa(int iterations) {
  Search search;
  search.iterations = iterations;
  return search;
}

Spsa small_spsa(double gain = 0.5) {
  return Spsa(SpsaGains{100, gain}, {{0, 10, 5, 0}, {0, 10, 5, 0}}, 7);
}

// Spall 1998, section III: a_k = a / (A + k + 1)^0.602, c_k = c / (k + 1)^0.101, A = 0.1 N.
TEST(SpsaGains, FallWithSpallsExponents) {
  const SpsaGains gains{100, 0.5};
  EXPECT_DOUBLE_EQ(gains.perturbation(0), 1);
  EXPECT_NEAR(gains.perturbation(99), std::exp(-0.101 * std::log(100)), 1e-12);
  EXPECT_NEAR(gains.gain_in(99) / gains.gain_in(0), std::exp(-0.602 * std::log(110 / 11.0)), 1e-12);
}

TEST(Spsa, PerturbsEveryParameterByOneStepAtFirst) {
  const std::vector<Candidate> candidates = small_spsa().ask();
  ASSERT_EQ(candidates.size(), 2U);
  for (Eigen::Index i = 0; i < 2; ++i) {
    EXPECT_DOUBLE_EQ(std::abs(candidates[0].point[i] - 5), 1);
    EXPECT_DOUBLE_EQ(candidates[0].point[i] + candidates[1].point[i], 10);
  }
}

TEST(Spsa, MovesByTheGainInTheFirstIteration) {
  Spsa search = small_spsa(0.5);
  const Point towards_plus = search.ask()[0].point - search.centre();
  search.tell(std::vector<Score>{1, 0});
  EXPECT_LT((search.centre() - Point::Constant(2, 5) - 0.5 * towards_plus).norm(), 1e-12);
}

TEST(Spsa, StaysIfAScoreIsUnknown) {
  Spsa search = small_spsa();
  search.tell(std::vector<Score>{std::nullopt, 3});
  EXPECT_EQ(search.centre(), Point::Constant(2, 5));
}

TEST(Spsa, MovesAtMostTwoPerturbationsWhateverTheScores) {
  Spsa search = small_spsa(50);
  search.tell(std::vector<Score>{1000, -1000});
  EXPECT_DOUBLE_EQ((search.centre() - Point::Constant(2, 5)).cwiseAbs().maxCoeff(), 2);
}

// Long games have more goals and more noise than short ones.
TEST(Spsa, DoesNotDependOnTheScaleOfTheScores) {
  Spsa one = small_spsa();
  Spsa other = small_spsa();
  for (int i = 0; i < 20; ++i) {
    one.tell(std::vector<Score>{i % 3, i % 4});
    other.tell(std::vector<Score>{7 * (i % 3), 7 * (i % 4)});
  }
  EXPECT_LT((one.centre() - other.centre()).norm(), 1e-12);
  EXPECT_GT((one.centre() - Point::Constant(2, 5)).norm(), 0.1);
}

TEST(Spsa, StaysInTheBox) {
  Spsa search(SpsaGains{50, 5}, {{0, 4, 4, 0}}, 1);
  for (int i = 0; i < 50; ++i) {
    for (const Candidate& candidate : search.ask()) {
      EXPECT_GE(candidate.point[0], 0);
      EXPECT_LE(candidate.point[0], 4);
    }
    const double plus = search.ask()[0].point[0];
    search.tell(std::vector<Score>{plus, search.ask()[1].point[0]});  // best at the edge
  }
  EXPECT_NEAR(search.best()[0], 4, 0.5);
}

TEST(Spsa, KeepsLookingHalfAWholeNumberAway) {
  Spsa search(SpsaGains{100, 0.1}, {{0, 10, 5, 0.5}}, 1);
  for (int i = 0; i < 2000; ++i) search.tell(std::vector<Score>{0, 0});
  EXPECT_LT(search.reach(), 0.5);
  EXPECT_DOUBLE_EQ(std::abs(search.ask()[0].point[0] - 5), 0.5);
}

TEST(Spsa, ResultIsTheMeanOfTheLastHalfOfItsPath) {
  Spsa search = small_spsa();
  std::vector<Point> path;
  for (int i = 0; i < 10; ++i) {
    search.tell(std::vector<Score>{i % 3, 0});
    path.push_back(search.centre());
  }
  Point sum = Point::Zero(2);
  for (std::size_t i = 5; i < 10; ++i) sum += path[i];
  EXPECT_LT((search.best() - sum / 5).norm(), 1e-12);
}

TEST(Spsa, RepeatsItsPathForTheSameSeedOnly) {
  NoisySearch one{spsa(30)};
  one.search.seed = 3;
  EXPECT_EQ(one.final_loss(bowl), one.final_loss(bowl));
  NoisySearch other = one;
  other.search.seed = 4;
  EXPECT_NE(one.final_loss(bowl), other.final_loss(bowl));
}

// The bounds are about 1.5 times the means over 400 seeds (docs/tuning.md).
TEST(Spsa, FindsTheOptimumOfTwoParametersInSpiteOfTheNoise) {
  EXPECT_LT((NoisySearch{spsa(125), 2}.mean_loss(bowl, kSeeds)), 0.06);
  EXPECT_LT((NoisySearch{spsa(125), 2}.mean_loss(valley, kSeeds)), 0.1);
}

TEST(Spsa, FindsMostOfTheGainOfEightParametersInSpiteOfTheNoise) {
  EXPECT_LT((NoisySearch{spsa(250), 8}.mean_loss(bowl, kSeeds)), 0.3);
  EXPECT_LT((NoisySearch{spsa(250), 8}.mean_loss(valley, kSeeds)), 0.3);
}

TEST(Spsa, NeedsFewerGamesAgainstItself) {
  NoisySearch others{spsa(60), 8};
  NoisySearch itself{spsa(120), 8};
  itself.against_itself = true;
  ASSERT_EQ(60 * others.games(), 120 * itself.games());
  EXPECT_LT(itself.mean_loss(bowl, kSeeds), others.mean_loss(bowl, kSeeds));
}

TEST(MakeOptimiser, RefusesAnEmptyOrImpossibleBox) {
  EXPECT_THROW(make_optimiser({}, {}), std::invalid_argument);
  EXPECT_THROW(make_optimiser({}, {Axis{0, 1, 2, 0}}), std::invalid_argument);
  EXPECT_THROW(make_optimiser({}, {Axis{1, 1, 1, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace autoref::experiments
