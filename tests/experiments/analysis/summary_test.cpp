#include "experiments/analysis/summary.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace autoref::experiments {
namespace {

const std::vector<Factor> kRobots = {{"b.robots", {6, 5}}};

struct FakeLeg {
  int goals_a = 0;
  int goals_b = 0;
  bool is_void = false;
};

FakeLeg void_leg(int goals_a, int goals_b) { return {goals_a, goals_b, true}; }

// The legs of a pair of games with that number of robots.
struct FakePair {
  const char* robots;
  int pair;
  std::vector<FakeLeg> legs;
};

GameRow row_of_leg(const FakePair& pair, std::size_t leg) {
  const FakeLeg& score = pair.legs[leg];
  GameRow row;
  row.record.goals_a = score.goals_a;
  row.record.goals_b = score.goals_b;
  row.record.status = score.is_void ? game::Status::kVoid : game::Status::kOk;
  row.pair = pair.pair;
  row.leg = static_cast<int>(leg) + 1;
  row.values = {pair.robots};
  return row;
}

std::vector<Group> groups_of(const std::vector<FakePair>& pairs) {
  RowsById rows;
  for (const FakePair& pair : pairs) {
    for (std::size_t leg = 0; leg < pair.legs.size(); ++leg)
      rows[fmt::format("game {:03}", rows.size())] = row_of_leg(pair, leg);
  }
  return grouped(kRobots, rows);
}

TEST(Summary, AveragesDifferencesOverThePairOfLegs) {
  const std::vector<Group> groups =
      groups_of({{"6", 1, {{3, 1}, {1, 1}}}, {"6", 2, {{0, 2}, {0, 4}}}});
  EXPECT_EQ(groups[0].differences, (std::vector<double>{2, 0, -2, -4}));
  EXPECT_EQ(groups[0].pair_differences, (DifferenceByPair{{1, 1}, {2, -3}}));
  EXPECT_TRUE(groups[1].differences.empty());
}

TEST(Summary, LeavesVoidGamesAndTheirPairsOut) {
  const std::vector<Group> groups =
      groups_of({{"6", 1, {{3, 1}, void_leg(9, 9)}}, {"6", 2, {{2, 0}, {1, 1}}}});
  EXPECT_EQ(groups[0].void_games, 1);
  EXPECT_EQ(groups[0].differences.size(), 3U);
  EXPECT_EQ(groups[0].pair_differences, (DifferenceByPair{{2, 1}}));
}

TEST(Summary, HasARowPerValueWithMeansAndDeviations) {
  const std::vector<Group> groups =
      groups_of({{"6", 1, {{1, 1}, {3, 1}}}, {"5", 1, {{4, 0}, {4, 0}}}});
  // The standard deviation of 1 and 3 is sqrt(2). Intervals of shares: Wilson's for 1 of 2; those
  // of Clopper and Pearson for 0 and 2 of 2 end at sqrt(0.025) = 0.1581 and 1 - sqrt(0.025).
  EXPECT_EQ(summary_csv(kRobots, groups),
            "b.robots,games,void_games,mean_a,sd_a,mean_b,sd_b,mean_diff,sd_diff,pairs,diff_low95,"
            "diff_high95,from_first,from_first_low95,from_first_high95,p,p_holm,effect_size,"
            "wins_a,draws,wins_b,wins_a_share,wins_a_low95,wins_a_high95,draws_share,draws_low95,"
            "draws_high95,wins_b_share,wins_b_low95,wins_b_high95\n"
            "6,2,0,2.0000,1.4142,1.0000,0.0000,1.0000,1.4142,1,,,,,,,,,"
            "1,1,0,0.5000,0.0945,0.9055,0.5000,0.0945,0.9055,0.0000,0.0000,0.8419\n"
            "5,2,0,4.0000,0.0000,0.0000,0.0000,4.0000,0.0000,1,,,3.0000,,,,,,"
            "2,0,0,1.0000,0.1581,1.0000,0.0000,0.0000,0.8419,0.0000,0.0000,0.8419\n");
}

TEST(Summary, FitsTheSlopeOverThePairs) {
  const std::vector<Group> groups =
      groups_of({{"6", 1, {{1, 1}, {3, 1}}}, {"5", 1, {{4, 0}, {4, 0}}}});
  EXPECT_NEAR(slope_over_factor(kRobots, groups).value().mean, -3.0, 1e-12);
}

TEST(Summary, ComputesTheSlopesIntervalOverPairNumbers) {
  const std::vector<Group> groups = groups_of({{"6", 1, {{1, 0}, {1, 0}}},
                                               {"6", 2, {{9, 0}, {9, 0}}},
                                               {"6", 3, {{5, 0}, {5, 0}}},
                                               {"5", 1, {{4, 0}, {4, 0}}},
                                               {"5", 2, {{10, 0}, {10, 0}}},
                                               {"5", 3, {{7, 0}, {7, 0}}}});
  const Slope slope = slope_over_factor(kRobots, groups).value();
  EXPECT_NEAR(slope.mean, -2.0, 1e-12);
  // Slopes -3, -1, -2: standard deviation 1, t(0.975, 2) = 4.302653 from tables.
  EXPECT_NEAR(slope.interval.value().low, -2 - 4.302653 / std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(slope.interval.value().high, -2 + 4.302653 / std::sqrt(3.0), 1e-6);
}

TEST(Summary, LeavesAPairNumberWithAVoidLegOutOfTheSlope) {
  const std::vector<Group> groups = groups_of({{"6", 1, {{1, 0}, {1, 0}}},
                                               {"6", 2, {{9, 0}, void_leg(9, 0)}},
                                               {"5", 1, {{4, 0}, {4, 0}}},
                                               {"5", 2, {{10, 0}, {10, 0}}}});
  const Slope slope = slope_over_factor(kRobots, groups).value();
  EXPECT_NEAR(slope.mean, -3.0, 1e-12);
  EXPECT_FALSE(slope.interval);
}

TEST(Summary, DoesNotFitASlopeOverNamesOrSeveralFactors) {
  Group basic;
  basic.values = {"basic"};
  basic.pair_differences = {{1, 1}};
  EXPECT_FALSE(slope_over_factor({{"a.strategy", {"basic", "dummy"}}}, {basic}));
  EXPECT_FALSE(slope_over_factor({{"a.robots", {6}}, {"b.robots", {6}}}, {}));
}

// The paired differences from the value of 6 robots are 3, 1 and 2: mean 2, standard deviation 1, t
// = 2 sqrt(3); with two degrees of freedom, the two-sided p is 0.0742 (scipy.stats.ttest_1samp([3,
// 1, 2], 0)).
TEST(SummaryTable, ComparesEachValueWithTheFirst) {
  const std::vector<Group> groups = groups_of({{"6", 1, {{1, 0}, {1, 0}}},
                                               {"6", 2, {{5, 0}, {5, 0}}},
                                               {"6", 3, {{0, 0}, {0, 0}}},
                                               {"5", 1, {{4, 0}, {4, 0}}},
                                               {"5", 2, {{6, 0}, {6, 0}}},
                                               {"5", 3, {{2, 0}, {2, 0}}}});
  const std::string table =
      io::text_of(summary_table(kRobots, groups, slope_over_factor(kRobots, groups)));
  EXPECT_NE(table.find("+2.00 [-0.48, +4.48]   0.074\n"), std::string::npos) << table;
}

TEST(SummaryTable, HasScoresDifferencesAndVoidGames) {
  const std::vector<Group> groups = groups_of(
      {{"6", 1, {{1, 1}, {3, 1}}}, {"6", 2, {{1, 1}, {1, 1}}}, {"5", 1, {void_leg(4, 0)}}});
  const std::string table = io::text_of(summary_table(kRobots, groups, std::nullopt));
  // The pairs' differences are 1 and 0: mean 0.5, t(0.975, 1) = 12.706, standard error 0.5.
  EXPECT_NE(table.find("+0.50 [-5.85, +6.85]"), std::string::npos) << table;
  EXPECT_NE(table.find("1.50 ± 1.00"), std::string::npos) << table;
}

}  // namespace
}  // namespace autoref::experiments
