#include "benchmarks/frame_costs.hpp"

#include <gtest/gtest.h>

namespace autoref::benchmarks {
namespace {

// The table of a series of 1, 2 and 4 robots whose frames always take these times; the second row
// is the base.
ScaleTable table_of(const std::vector<double>& costs_ns) {
  ScaleSeries series{"robots", "robot", {{"1", 1, {}}, {"2", 2, {}}, {"4", 4, {}}}, 1};
  std::vector<std::vector<double>> ns;
  ns.reserve(costs_ns.size());
  for (const double cost_ns : costs_ns) ns.emplace_back(kFewestRounds, cost_ns);
  return scale_table(series, ns);
}

TEST(ScaleTable, ComparesWithTheBaseRow) {
  const ScaleTable table = table_of({50, 100, 150});
  EXPECT_DOUBLE_EQ(table.base_ns_per_frame, 100);
  EXPECT_DOUBLE_EQ(table.rows[2].ratio.median, 1.5);
  EXPECT_DOUBLE_EQ(table.per_unit(table.rows[2]) * table.rows[2].ratio.median, 0.75);
}

TEST(ScaleTable, KnowsWhetherTheCostPerRobotGrows) {
  EXPECT_EQ(growth_of(table_of({50, 100, 200})), Growth::kLinearOrBetter);
  EXPECT_EQ(growth_of(table_of({90, 100, 201})), Growth::kSuperlinear);
}

TEST(ScaleTable, DoesNotDecideIfTheIntervalContainsEquality) {
  ScaleTable table = table_of({50, 100, 201});
  table.rows[2].ratio.interval = {1.9, 2.1};
  EXPECT_EQ(growth_of(table), Growth::kUndecided);
}

TEST(ScaleSeries, HasOneToSixteenRobotsASide) {
  const std::vector<ScaleSeries> all = scale_series({});
  ASSERT_EQ(all.size(), 3U);
  ASSERT_EQ(all[0].games.size(), 16U);
  EXPECT_EQ(all[0].games[all[0].base].units, 6);
  EXPECT_EQ(all[0].games[15].game.b.robots.size(), 16U);
}

}  // namespace
}  // namespace autoref::benchmarks
