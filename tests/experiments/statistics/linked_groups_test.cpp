#include "experiments/statistics/rated_games.hpp"

#include <gtest/gtest.h>

namespace autoref::experiments {
namespace {

TEST(LinkedGroups, ContainTeamsThatMetDirectlyOrThroughOthers) {
  EXPECT_EQ(linked_groups(6, std::vector<MatchupTotals>{{.a = 4, .b = 1, .games = 2},
                                                        {.a = 3, .b = 2, .games = 2},
                                                        {.a = 3, .b = 4, .games = 1},
                                                        {.a = 0, .b = 5}}),
            (std::vector<std::size_t>{0, 1, 1, 1, 1, 2}));
}

TEST(GroupMeans, ReplaceEachTeamByTheMeanOfItsGroup) {
  const Eigen::VectorXd means = group_means({0, 1, 0}) * Eigen::Vector3d(1, 5, 4);
  EXPECT_NEAR(means(0), 2.5, 1e-12);
  EXPECT_NEAR(means(1), 5, 1e-12);
  EXPECT_NEAR(means(2), 2.5, 1e-12);
}

}  // namespace
}  // namespace autoref::experiments
