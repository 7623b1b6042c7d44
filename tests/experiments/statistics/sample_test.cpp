// Published expected values: R's documentation of its data sets `sleep` (Student 1908) and
// `anscombe`, as printed by t.test() and lm().
#include "experiments/statistics/sample.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "experiments/statistics/interval.hpp"

namespace autoref::experiments {
namespace {

// Extra hours of sleep of ten patients, drug 2 minus drug 1.
const std::vector<double> kSleep = {1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4};

const std::vector<double> kAnscombeX = {10, 8, 13, 9, 11, 14, 6, 4, 12, 7, 5};
const std::vector<double> kAnscombeY = {8.04, 6.95, 7.58,  8.81, 8.33, 9.96,
                                        7.24, 4.26, 10.84, 4.82, 5.68};

TEST(Mean, OfStudentsSleepData) { EXPECT_NEAR(mean(kSleep), 1.58, 1e-12); }

TEST(StandardDeviation, OfStudentsSleepData) {
  EXPECT_NEAR(standard_deviation(kSleep).value(), 1.229995, 5e-7);
}

TEST(StandardDeviation, NeedsTwoValues) {
  EXPECT_FALSE(standard_deviation(std::vector<double>{1.0}));
  EXPECT_FALSE(mean_interval(std::vector<double>{1.0}));
  EXPECT_FALSE(mean_interval(std::vector<double>{-6.0, -6.0, -6.0}));
}

TEST(MeanInterval, OfStudentsSleepData) {
  const Interval interval = mean_interval(kSleep).value();
  EXPECT_NEAR(interval.low, 0.7001142, 5e-8);
  EXPECT_NEAR(interval.high, 2.4598858, 5e-8);
}

TEST(PValueOfZeroMean, OfStudentsSleepData) {
  EXPECT_NEAR(p_of_zero_mean(kSleep).value(), 0.00283289, 5e-9);
}

TEST(PValueOfZeroMean, IsTheSameOnBothSidesOfZero) {
  std::vector<double> negative;
  for (const double hours : kSleep) negative.push_back(-hours);
  EXPECT_EQ(p_of_zero_mean(negative), p_of_zero_mean(kSleep));
}

TEST(PValueOfZeroMean, NeedsTwoDifferentValues) {
  EXPECT_FALSE(p_of_zero_mean(std::vector<double>{1.0}));
  EXPECT_FALSE(p_of_zero_mean(std::vector<double>{1.0, 1.0, 1.0}));
}

TEST(SlopeOf, AnscombesFirstSet) {
  EXPECT_NEAR(slope_of(kAnscombeX, kAnscombeY).value(), 0.5000909, 5e-8);
}

TEST(SlopeOf, NeedsTwoDifferentX) {
  EXPECT_FALSE(slope_of(std::vector<double>{1, 1}, std::vector<double>{1, 2}));
  EXPECT_EQ(slope_of(std::vector<double>{0, 2}, std::vector<double>{1, 5}), 2.0);
}

}  // namespace
}  // namespace autoref::experiments
