#include "experiments/tune/cma_es.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/experiments/tune/noisy_search.hpp"

namespace autoref::experiments {
namespace {

constexpr int kCmaSeeds = 30;  // that tests average over

Search cma_es(int iterations) {
  Search search;
  search.method = Method::kCmaEs;
  search.iterations = iterations;
  return search;
}

// Hansen 2016, table 1; mu_eff of lambda = 10 is 3.167 in his purecma.py.
TEST(CmaConstants, AreThoseOfTheTutorial) {
  const CmaConstants c(10);
  EXPECT_EQ(c.lambda, 10);
  EXPECT_EQ(c.weights.size(), 5);
  EXPECT_NEAR(c.weights.sum(), 1, 1e-12);
  EXPECT_NEAR(c.mu_eff, 3.167, 1e-3);
  EXPECT_NEAR(c.c_sigma, (3.167 + 2) / (10 + 3.167 + 5), 1e-3);
  EXPECT_NEAR(c.chi_n, 3.0847, 1e-3);  // sqrt(2) Gamma(5.5) / Gamma(5) = 3.0843
  EXPECT_EQ(CmaConstants(2).lambda, 6);
}

double rosenbrock(const Point& x) {
  double sum = 0;
  for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
    const double off = x[i + 1] - x[i] * x[i];
    sum += 100 * off * off + (1 - x[i]) * (1 - x[i]);
  }
  return sum;
}

// Without noise. CMA-ES is known to need about 1300 evaluations in five dimensions for 1e-8.
TEST(CmaEs, SolvesRosenbrocksFunction) {
  CmaEs search(std::vector<Axis>(5, Axis{-5, 5, -1, 0}), 3);
  for (int i = 0; i < 500; ++i) {
    std::vector<Score> scores;
    for (const Candidate& candidate : search.ask()) scores.push_back(-rosenbrock(candidate.point));
    search.tell(scores);
  }
  EXPECT_LT(rosenbrock(search.centre()), 1e-8);
}

TEST(CmaEs, FindsAnOptimumOnTheEdgeOfTheBox) {
  CmaEs search(std::vector<Axis>(3, Axis{0, 5, 2, 0}), 1);
  for (int i = 0; i < 100; ++i) {
    std::vector<Score> scores;
    for (const Candidate& candidate : search.ask()) {
      EXPECT_GE(candidate.point.minCoeff(), 0);
      EXPECT_LE(candidate.point.maxCoeff(), 5);
      scores.push_back(candidate.point.sum());
    }
    search.tell(scores);
  }
  EXPECT_NEAR(search.best().minCoeff(), 5, 0.1);
  EXPECT_LT(search.reach(), 10);  // the penalty keeps the distribution near the box
}

TEST(CmaEs, RanksCandidatesWithoutScoreLast) {
  CmaEs search(std::vector<Axis>(1, Axis{-100, 100, 0, 0}), 1);
  std::vector<Score> scores;
  double best = -100;
  for (const Candidate& candidate : search.ask()) {
    const double x = candidate.point[0];
    scores.push_back(x > 0 ? Score(x) : std::nullopt);
    best = std::max(best, x);
  }
  ASSERT_GT(best, 0);
  search.tell(scores);
  EXPECT_GT(search.centre()[0], 0);
}

TEST(CmaEs, SurvivesEqualScores) {
  CmaEs search(std::vector<Axis>(2, Axis{0, 5, 2, 0}), 1);
  const std::vector<Score> equal(search.ask().size(), 0);
  for (int i = 0; i < 300; ++i) search.tell(equal);
  EXPECT_TRUE(search.best().allFinite());
  EXPECT_TRUE(std::isfinite(search.reach()));
}

// The bounds are about 1.5 times the means over 400 seeds (docs/tuning.md).
TEST(CmaEs, FindsMostOfTheGainOfTwoParametersInSpiteOfTheNoise) {
  NoisySearch search{cma_es(21), 2, 8};
  EXPECT_LT(search.mean_loss(bowl, kCmaSeeds), 0.25);
  EXPECT_LT(search.mean_loss(valley, kCmaSeeds), 0.3);
}

TEST(CmaEs, ImprovesEightParametersInSpiteOfTheNoise) {
  EXPECT_LT((NoisySearch{cma_es(25), 8, 8}.mean_loss(bowl, kCmaSeeds)), 0.55);
}

}  // namespace
}  // namespace autoref::experiments
