#include "logs/compare/measured_games.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace autoref::logs {
namespace {

std::size_t index_of(Measure measure) { return static_cast<std::size_t>(measure); }

TEST(MeasuredGames, KeepBlocksOfDifferentLogsAndTimesApart) {
  MeasuredGames games;
  games.start_log();
  games.add(1, Measure::kRobotSpeed, -1, 1);
  games.add(1, Measure::kRobotSpeed, 1, 1);
  games.add(1, Measure::kRobotSpeed, MeasuredGames::kBlock_s - 0.1, 2);
  games.start_log();
  games.add(2, Measure::kRobotSpeed, 1, 3);
  EXPECT_EQ(games.blocks().size(), 3U);
  EXPECT_EQ(games.total()[index_of(Measure::kRobotSpeed)].values(), 4);
}

TEST(MeasuredGames, CountsValuesAboveTheHighestAsTheHighest) {
  MeasuredGames games;
  games.start_log();
  games.add(1, Measure::kRobotSpeed, 0, 1000);
  games.add(1, Measure::kRobotSpeed, 0, 0);
  const AllCounts total = games.total();
  EXPECT_EQ(total[index_of(Measure::kRobotSpeed)].bins().front(), 1);
  EXPECT_EQ(total[index_of(Measure::kRobotSpeed)].bins().back(), 1);
}

TEST(MeasuredGames, HaveABoundedNumberOfBlocksAndLoseNothing) {
  constexpr int kAdded = 20'000;
  MeasuredGames games;
  games.start_log();
  for (int i = 0; i < kAdded; ++i)
    games.add(1, Measure::kKickSpeed, (i - 100) * MeasuredGames::kBlock_s, 2);
  EXPECT_LE(games.blocks().size(), MeasuredGames::kMostBlocks);
  EXPECT_GT(games.blocks().size(), MeasuredGames::kMostBlocks / 3);
  EXPECT_EQ(games.total()[index_of(Measure::kKickSpeed)].values(), kAdded);
}

TEST(MeasuredGames, MayBeOfMoreLogsThanBlocks) {
  const int logs = static_cast<int>(2 * MeasuredGames::kMostBlocks);
  MeasuredGames games;
  for (int log = 1; log <= logs; ++log) {
    games.start_log();
    games.add(log, Measure::kKickSpeed, 1, 2);
  }
  EXPECT_EQ(games.blocks().size(), static_cast<std::size_t>(logs));
}

TEST(MeasuredGames, IgnoreWhatIsNotFinite) {
  MeasuredGames games;
  games.start_log();
  games.add(1, Measure::kKickSpeed, std::nan(""), 2);
  games.add(1, Measure::kKickSpeed, 1, std::nan(""));
  EXPECT_EQ(games.total()[index_of(Measure::kKickSpeed)].values(), 0);
}

TEST(MeasuredGames, DiscardOneMeasureOfOneLog) {
  MeasuredGames games;
  for (const int log : {1, 2}) {
    games.start_log();
    games.add(log, Measure::kStops, 1, 1);
    games.add_time(log, Measure::kStops, 1, 5);
    games.add(log, Measure::kFouls, 1, 1);
  }
  games.discard(2, Measure::kStops);
  const AllCounts total = games.total();
  EXPECT_EQ(total[index_of(Measure::kStops)].values(), 1);
  EXPECT_EQ(total[index_of(Measure::kStops)].duration_s(), 5);
  EXPECT_EQ(total[index_of(Measure::kFouls)].values(), 2);
}

TEST(MeasuredGames, MeasuresAreInTheOrderOfTheirNumbers) {
  for (std::size_t i = 0; i < kMeasureCount; ++i) EXPECT_EQ(index_of(kMeasures[i].measure), i);
}

}  // namespace
}  // namespace autoref::logs
