#include "experiments/statistics/paired_difference.hpp"

#include <gtest/gtest.h>

namespace autoref::experiments {
namespace {

const DifferenceByPair kBaseline = {{1, 0.5}, {2, 0.0}, {3, 0.5}, {4, -1.0}, {5, 0.0}, {6, 1.0}};
const DifferenceByPair kValue = {{1, 1.5}, {2, -0.5}, {3, 2.0}, {4, 1.0}, {5, 0.0}, {6, 2.5}};

// SciPy 1.10: scipy.stats.ttest_rel(value, baseline) and, with d their difference,
// scipy.stats.t.interval(0.95, 5, d.mean(), scipy.stats.sem(d)), d.mean() / d.std(ddof=1).
TEST(PairedDifference, MatchesSciPy) {
  const PairedDifference difference = paired_difference(kValue, kBaseline);
  EXPECT_EQ(difference.pairs, 6);
  EXPECT_NEAR(difference.mean.value(), 0.9166666666666666, 1e-12);
  EXPECT_NEAR(difference.interval.value().low, -0.1017005453972345, 1e-8);
  EXPECT_NEAR(difference.interval.value().high, 1.9350338787305676, 1e-8);
  EXPECT_NEAR(difference.p.value(), 0.06857575483054949, 1e-12);
  EXPECT_NEAR(difference.effect_size.value(), 0.9446324065374985, 1e-12);
}

TEST(PairedDifference, ComparesOnlyPairsThatBothHave) {
  const PairedDifference difference =
      paired_difference({{1, 2.0}, {2, 9.0}, {4, 5.0}}, {{1, 1.0}, {3, 7.0}, {4, 3.0}});
  EXPECT_EQ(difference.pairs, 2);
  EXPECT_EQ(difference.mean, 1.5);
}

TEST(PairedDifference, IsEmptyWithoutCommonPairs) {
  const PairedDifference difference = paired_difference({{1, 2.0}}, {{2, 1.0}});
  EXPECT_EQ(difference.pairs, 0);
  EXPECT_FALSE(difference.mean || difference.interval || difference.p || difference.effect_size);
}

TEST(PairedDifference, HasNoPIfAllPairsHaveTheSameDifference) {
  const PairedDifference same = paired_difference(kValue, kValue);
  EXPECT_EQ(same.mean, 0.0);
  EXPECT_FALSE(same.p || same.effect_size);
}

// statsmodels 0.13: multipletests(p, method='holm')[1].
TEST(Holm, MatchesStatsmodels) {
  const std::vector<double> corrected = holm(std::vector{0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected = {0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(corrected.at(i), expected[i], 1e-15);
}

TEST(Holm, GivesEqualPTheSameValueAndNoneAboveOne) {
  EXPECT_EQ(holm(std::vector{0.02, 0.02, 0.5, 0.6}), (std::vector{0.08, 0.08, 1.0, 1.0}));
}

TEST(DifferencesFromBaseline, AreThoseOfAllValuesExceptTheFirst) {
  const auto differences = differences_from_baseline(std::vector{kBaseline, kValue, kBaseline});
  ASSERT_EQ(differences.size(), 2);
  EXPECT_NEAR(differences[0].mean.value(), 0.9166666666666666, 1e-12);
  EXPECT_EQ(differences[1].mean, 0.0);
}

TEST(DifferencesFromBaseline, AreCorrectedOverTheValuesWithAP) {
  const auto differences =
      differences_from_baseline(std::vector{kBaseline, kValue, kBaseline, kValue});
  EXPECT_NEAR(differences[0].p_holm.value(), 2 * 0.06857575483054949, 1e-12);
  EXPECT_FALSE(differences[1].p_holm);
  EXPECT_EQ(differences[2].p_holm, differences[0].p_holm);
}

TEST(DifferencesFromBaseline, AreEmptyForOnlyABaseline) {
  EXPECT_TRUE(differences_from_baseline(std::vector{kBaseline}).empty());
  EXPECT_TRUE(differences_from_baseline({}).empty());
}

}  // namespace
}  // namespace autoref::experiments
