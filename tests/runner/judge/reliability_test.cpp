#include "runner/judge/reliability.hpp"

#include <gtest/gtest.h>

namespace autoref::runner {
namespace {

using ground_truth::Outcome;
using ground_truth::Verdict;

Verdict call_of_confidence(double confidence, Outcome outcome) {
  Verdict verdict;
  verdict.outcome = outcome;
  verdict.confidence = confidence;
  return verdict;
}

TEST(Reliability, CountsCallsInBandsThatIncludeTheirLowerEnds) {
  Reliability reliability;
  reliability.add(call_of_confidence(0.9, Outcome::kRight));
  reliability.add(call_of_confidence(0.94, Outcome::kWrong));
  reliability.add(call_of_confidence(0.95, Outcome::kRight));
  reliability.add(call_of_confidence(1.0, Outcome::kRight));
  reliability.add(call_of_confidence(0.0, Outcome::kWrong));
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
  Verdict missed;
  missed.outcome = Outcome::kMissed;
  reliability.add(missed);
  for (std::size_t i = 0; i < Reliability::kFrom.size(); ++i)
    EXPECT_EQ(reliability.band(i).calls, 0);
}

TEST(Reliability, AddsUp) {
  Reliability one;
  one.add(call_of_confidence(0.9, Outcome::kRight));
  Reliability two;
  two.add(call_of_confidence(0.92, Outcome::kWrong));
  two.add(one);
  EXPECT_EQ(two.band(5).calls, 2);
  EXPECT_EQ(two.band(5).right, 1);
  EXPECT_DOUBLE_EQ(two.band(5).confidence_sum, 1.82);
}

}  // namespace
}  // namespace autoref::runner
