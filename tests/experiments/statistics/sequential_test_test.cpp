#include "experiments/statistics/sequential_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace autoref::experiments {
namespace {

// Ratios from SciPy 1.10, for the pair differences x: f(1) - f(0) with f(d) = norm.logpdf(x, d,
// sqrt(max(((x - d)**2).mean(), 1))).sum(). Wald's bounds for alpha = beta = 0.05 are -+log(19) =
// -+2.944439.
const std::vector<double> kNotQuiteEnough = {0.5, 1.5, 0, -0.5, 2, 1, 1, 0.5, 1.5, 0};
constexpr double kNotQuiteEnoughRatio = 2.463915178281919;
const std::vector<double> kMuch = {2.5, 1.5, 0, 0.5, 2, 1, 1, 1.5, 1.5, 2};
constexpr double kMuchRatio = 6.093600195196601;

std::vector<double> repeated(double difference, int pairs) {
  return std::vector<double>(static_cast<std::size_t>(pairs), difference);
}

std::vector<double> in_place_of(std::vector<double> differences, double d0_plus_d1) {
  for (double& difference : differences) difference = d0_plus_d1 - difference;
  return differences;
}

TEST(SequentialTest, ContinuesBetweenWaldsBounds) {
  const SequentialState state = decided_by(SequentialTest{}, kNotQuiteEnough);
  EXPECT_EQ(state.verdict, Verdict::kGoOn);
  EXPECT_NEAR(state.log_likelihood_ratio, kNotQuiteEnoughRatio, 1e-12);
}

TEST(SequentialTest, AcceptsD1AboveTheUpperBound) {
  const SequentialState state = decided_by(SequentialTest{}, kMuch);
  EXPECT_EQ(state.verdict, Verdict::kAcceptD1);
  EXPECT_NEAR(state.log_likelihood_ratio, kMuchRatio, 1e-12);
}

TEST(SequentialTest, AcceptsD0BelowTheLowerBound) {
  const SequentialState state = decided_by(SequentialTest{}, in_place_of(kMuch, 1));
  EXPECT_EQ(state.verdict, Verdict::kAcceptD0);
  EXPECT_NEAR(state.log_likelihood_ratio, -kMuchRatio, 1e-12);
}

TEST(SequentialTest, DerivesBoundsFromTheErrorRates) {
  // The bounds log((1 - 0.05) / 0.1) = 2.25 and log((1 - 0.5) / 0.05) = 2.30 are below the ratio.
  EXPECT_EQ(decided_by(SequentialTest{.alpha = 0.1}, kNotQuiteEnough).verdict, Verdict::kAcceptD1);
  EXPECT_EQ(decided_by(SequentialTest{.beta = 0.5}, kNotQuiteEnough).verdict, Verdict::kAcceptD1);
  EXPECT_EQ(decided_by(SequentialTest{.alpha = 0.001}, kMuch).verdict, Verdict::kGoOn);
}

TEST(SequentialTest, DecidesNothingBeforeItsMinimumOfPairs) {
  EXPECT_EQ(decided_by(SequentialTest{}, repeated(1, 9)).verdict, Verdict::kGoOn);
  EXPECT_EQ(decided_by(SequentialTest{}, repeated(1, 10)).verdict, Verdict::kAcceptD1);
}

TEST(SequentialTest, KeepsItsVerdictWhateverComesAfter) {
  std::vector<double> differences = kMuch;
  for (int i = 0; i < 30; ++i) differences.push_back(-3);
  const SequentialState state = decided_by(SequentialTest{}, differences);
  EXPECT_EQ(state.verdict, Verdict::kAcceptD1);
  EXPECT_EQ(state.pairs, 10);
}

TEST(SequentialTest, EndsUndecidedAtItsMaximumOfPairs) {
  const SequentialTest test{.max_pairs = 20};
  EXPECT_EQ(decided_by(test, repeated(0.5, 19)).verdict, Verdict::kGoOn);
  const SequentialState state = decided_by(test, repeated(0.5, 25));
  EXPECT_EQ(state.verdict, Verdict::kUndecided);
  EXPECT_EQ(state.pairs, 20);
}

TEST(SequentialTest, DecidesAtItsMaximumOfPairsIfItCan) {
  EXPECT_EQ(decided_by(SequentialTest{.max_pairs = 10}, kMuch).verdict, Verdict::kAcceptD1);
}

TEST(SequentialTest, DecidesIfAllPairsAreTheSame) {
  EXPECT_EQ(decided_by(SequentialTest{}, repeated(0, 10)).verdict, Verdict::kAcceptD0);
  EXPECT_EQ(decided_by(SequentialTest{}, repeated(1, 10)).verdict, Verdict::kAcceptD1);
  EXPECT_EQ(decided_by(SequentialTest{}, repeated(0.5, 10)).log_likelihood_ratio, 0.0);
}

TEST(SequentialTest, DoesNotTakeTheFirstGoallessPairsForCertainty) {
  const SequentialTest rare{.d0 = 0, .d1 = 0.1};
  const SequentialState state = decided_by(rare, repeated(0, 10));
  EXPECT_EQ(state.verdict, Verdict::kGoOn);
  EXPECT_NEAR(state.log_likelihood_ratio, -10 * 0.1 * 0.1 / (2 * 0.1), 1e-12);
  EXPECT_EQ(decided_by(rare, repeated(0, 59)).verdict, Verdict::kAcceptD0);
  EXPECT_EQ(decided_by(rare, repeated(0.1, 58)).verdict, Verdict::kGoOn);
  EXPECT_EQ(decided_by(rare, repeated(0.1, 59)).verdict, Verdict::kAcceptD1);
}

TEST(SequentialTest, KnowsTheLeastVarianceFromTheLargerHypothesis) {
  EXPECT_DOUBLE_EQ(least_variance_of({.d0 = -3, .d1 = -2}), 3);
  EXPECT_DOUBLE_EQ(least_variance_of({.d0 = 0, .d1 = 0.5}), 0.5);
}

TEST(SequentialTest, ContinuesBeforeTheFirstPair) {
  const SequentialState state = decided_by(SequentialTest{}, {});
  EXPECT_EQ(state.verdict, Verdict::kGoOn);
  EXPECT_EQ(state.pairs, 0);
}

TEST(SequentialTest, CanTestForANegativeDifference) {
  EXPECT_EQ(decided_by(SequentialTest{.d0 = 0, .d1 = -1}, in_place_of(kMuch, 0)).verdict,
            Verdict::kAcceptD1);
}

}  // namespace
}  // namespace autoref::experiments
