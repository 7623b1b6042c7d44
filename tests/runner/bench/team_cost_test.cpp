#include "runner/bench/team_cost.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace autoref::runner {
namespace {

TEST(CostOfTeam, IsAboutTheTeamNamed) {
  const TeamCost cost = cost_of_team("dummy");
  EXPECT_EQ(cost.name, "dummy");
  EXPECT_GT(cost.ns_per_decision, 0);
}

TEST(CostOfTeam, RefusesAnUnknownTeam) {
  EXPECT_THROW(cost_of_team("none"), std::invalid_argument);
}

}  // namespace
}  // namespace autoref::runner
