#include "benchmarks/whole_games.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace autoref::benchmarks {
namespace {

TEST(CostOfTeam, MeasuresTheNamedTeam) {
  const TeamCost cost = cost_of_team("dummy");
  EXPECT_EQ(cost.name, "dummy");
  // Two halves of 300 s at 60 Hz, plus a few seconds before and between them, for both sides.
  EXPECT_GE(cost.decisions, 2 * 2 * 300 * 60);
  EXPECT_LT(cost.decisions, 2 * 2 * 310 * 60);
}

// The dummy only returns: a call and two clock reads take from some ten nanoseconds to a
// microsecond, however busy the machine is.
TEST(CostOfTeam, IsOnlyThatOfReadingTheClockForAnIdleTeam) {
  const TeamCost cost = cost_of_team("dummy");
  EXPECT_GT(cost.ns_per_decision, 5);
  EXPECT_LT(cost.ns_per_decision, 5000);
}

TEST(CostOfTeam, RefusesAnUnknownTeam) {
  EXPECT_THROW(cost_of_team("none"), std::invalid_argument);
}

}  // namespace
}  // namespace autoref::benchmarks
