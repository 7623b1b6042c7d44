#include "experiments/statistics/interval.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "soccer/random.hpp"

namespace autoref::experiments {
namespace {

struct CallCounts {
  int right = 0;
  int wrong = 0;
  int missed = 0;
};

TEST(F1Interval, ContainsF1) {
  const Interval interval = f1_interval(90, 4, 16).value();
  EXPECT_LT(interval.low, 0.9);  // F1 = 180 / (180 + 20)
  EXPECT_GT(interval.high, 0.9);
}

TEST(F1Interval, IsWilsonsIfEveryMistakeIsMissedAndWrong) {
  EXPECT_EQ(f1_interval(57, 3, 3)->low, wilson_interval(57, 60)->low);
  EXPECT_EQ(f1_interval(57, 3, 3)->high, wilson_interval(57, 60)->high);
}

TEST(F1Interval, NeedsAnEventOrACall) {
  EXPECT_FALSE(f1_interval(0, 0, 0));
  EXPECT_EQ(f1_interval(0, 1, 0)->low, 0.0);
}

// The proportion of simulated samples whose interval contains the true value.
double coverage(double f1, const std::function<CallCounts(RandomStream&)>& sample) {
  constexpr int kSamples = 10000;
  RandomStream random(2016);
  int contained = 0;
  for (int i = 0; i < kSamples; ++i) {
    const CallCounts counts = sample(random);
    const auto interval = f1_interval(counts.right, counts.wrong, counts.missed);
    contained += interval && interval->low <= f1 && f1 <= interval->high ? 1 : 0;
  }
  return static_cast<double>(contained) / kSamples;
}

// Each event is called right, or for the wrong side, which is a missed event and a wrong call.
CallCounts called_for_wrong_sides(int events, double share_right, RandomStream& random) {
  CallCounts counts;
  for (int i = 0; i < events; ++i) {
    ++(random.uniform() < share_right ? counts.right : counts.missed);
  }
  counts.wrong = counts.missed;
  return counts;
}

// Each event is called or missed; wrong calls come independently, one chance per event.
CallCounts with_independent_mistakes(int events, double recall, double wrong_share,
                                     RandomStream& random) {
  CallCounts counts;
  for (int i = 0; i < events; ++i) {
    ++(random.uniform() < recall ? counts.right : counts.missed);
    counts.wrong += random.uniform() < wrong_share ? 1 : 0;
  }
  return counts;
}

class F1Coverage : public testing::TestWithParam<int> {};

// Wilson's coverage swings by some per cent around 95 %, since counts are whole numbers.
TEST_P(F1Coverage, IsWilsonsIfSidesAreMixedUp) {
  const auto covered = [](double share) {
    return coverage(share, [share](RandomStream& random) {
      return called_for_wrong_sides(GetParam(), share, random);
    });
  };
  EXPECT_NEAR((covered(0.85) + covered(0.9) + covered(0.94) + covered(0.97)) / 4, 0.95, 0.015);
}

TEST_P(F1Coverage, IsMoreThanEnoughIfMistakesAreIndependent) {
  for (const double recall : {0.8, 0.9, 0.95, 0.98}) {
    const double wrong_share = 1 - recall;
    const double f1 = 2 * recall / (2 * recall + 2 * wrong_share);
    EXPECT_GE(coverage(f1,
                       [&](RandomStream& random) {
                         return with_independent_mistakes(GetParam(), recall, wrong_share, random);
                       }),
              0.945)
        << recall;
  }
}

INSTANTIATE_TEST_SUITE_P(Events, F1Coverage, testing::Values(30, 100, 400));

}  // namespace
}  // namespace autoref::experiments
