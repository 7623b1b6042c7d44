#include "tools/planted/games_report.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace autoref::tools {
namespace {

using experiments::Interval;

MeasuredDifference goals_within(Interval interval) {
  MeasuredDifference goals;
  goals.measure = "goals";
  goals.interval = interval;
  return goals;
}

MeasuredDifference xg_with(Interval relative_games) {
  MeasuredDifference xg;
  xg.measure = kXg;
  xg.relative = {relative_games.low, relative_games};
  xg.minus_goals_interval = Interval{-1, 1};
  return xg;
}

const MeasuredDifference kCertain = goals_within({0.1, 0.5});

TEST(GamesVerdict, IsUnknownIfTheDifferenceInGoalsIsUncertain) {
  EXPECT_EQ(verdict_of(xg_with({0.2, 0.4}), goals_within({-0.1, 0.5})), GamesVerdict::kUnknown);
  EXPECT_EQ(verdict_of(xg_with({0.2, 0.4}), MeasuredDifference()), GamesVerdict::kUnknown);
}

TEST(GamesVerdict, FollowsFromTheIntervalOfTheFactor) {
  EXPECT_EQ(verdict_of(xg_with({0.2, 0.4}), kCertain), GamesVerdict::kFewer);
  EXPECT_EQ(verdict_of(xg_with({0.2, 1.4}), kCertain), GamesVerdict::kUncertain);
  EXPECT_EQ(verdict_of(xg_with({1.2, 1.4}), kCertain), GamesVerdict::kMore);
}

TEST(GamesReport, EndsWithTheAnswer) {
  MeasuredDifference biased = xg_with({1.2, 1.4});
  biased.minus_goals_interval = Interval{0.1, 0.2};
  const std::vector<MeasuredChange> changes = {{"slow", {kCertain, xg_with({0.2, 0.4})}},
                                               {"lame", {kCertain, biased}}};
  const std::string page = experiments::markdown_of(games_report(changes, 10));
  EXPECT_TRUE(page.ends_with(
      "Of the changes with a certain difference in goals, xG needs fewer games than goals for 1 "
      "(slow), more games for 1 (lame), and an uncertain number for 0; the median is 0.70 times as "
      "many. The mean by xG certainly differs from that by goals for 1 of the 2 changes: lame.\n"))
      << page;
}

TEST(GamesReport, LeavesTheAnswerOpenIfNoDifferenceIsCertain) {
  const std::vector<MeasuredChange> changes = {
      {"slow", {goals_within({-0.1, 0.5}), xg_with({0.2, 0.4})}}};
  EXPECT_NE(experiments::markdown_of(games_report(changes, 10)).find("it remains open"),
            std::string::npos);
}

}  // namespace
}  // namespace autoref::tools
