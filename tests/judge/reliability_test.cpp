#include "judge/judge_tally.hpp"

#include <gtest/gtest.h>

namespace autoref::judge {
namespace {

experiments::CallVerdict call_of_confidence(double confidence, experiments::CallOutcome outcome) {
  experiments::CallVerdict verdict;
  verdict.outcome = outcome;
  verdict.confidence = confidence;
  return verdict;
}

TEST(Reliability, CountsCallsInBandsThatIncludeTheirLowerEnds) {
  Reliability reliability;
  reliability.add(call_of_confidence(0.9, experiments::CallOutcome::kRight));
  reliability.add(call_of_confidence(0.94, experiments::CallOutcome::kWrong));
  reliability.add(call_of_confidence(0.95, experiments::CallOutcome::kRight));
  reliability.add(call_of_confidence(1.0, experiments::CallOutcome::kRight));
  reliability.add(call_of_confidence(0.0, experiments::CallOutcome::kWrong));
  const ReliabilityBand& nine = reliability.band(5);
  EXPECT_EQ(nine.calls, 2);
  EXPECT_EQ(nine.right, 1);
  EXPECT_DOUBLE_EQ(nine.confidence_sum, 1.84);
  EXPECT_EQ(reliability.band(6).right, 1);
  EXPECT_EQ(reliability.band(7).right, 1);
  EXPECT_EQ(reliability.band(0).calls, 1);
  EXPECT_EQ(reliability.band(0).right, 0);
}

TEST(Reliability, DoesNotCountWhatWasNotCalled) {
  Reliability reliability;
  experiments::CallVerdict missed;
  missed.outcome = experiments::CallOutcome::kMissed;
  reliability.add(missed);
  for (std::size_t i = 0; i < Reliability::kFrom.size(); ++i)
    EXPECT_EQ(reliability.band(i).calls, 0);
}

TEST(Reliability, AddsUp) {
  Reliability one;
  one.add(call_of_confidence(0.9, experiments::CallOutcome::kRight));
  Reliability two;
  two.add(call_of_confidence(0.92, experiments::CallOutcome::kWrong));
  two.add(one);
  EXPECT_EQ(two.band(5).calls, 2);
  EXPECT_EQ(two.band(5).right, 1);
  EXPECT_DOUBLE_EQ(two.band(5).confidence_sum, 1.82);
}

}  // namespace
}  // namespace autoref::judge
