#include "logs/compare/game_comparison.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "soccer/random.hpp"

namespace autoref::logs {
namespace {

using Draw = std::function<double(RandomStream&)>;

double uniform(RandomStream& random) { return boost::random::uniform_01<double>()(random); }

// A log of `blocks` blocks with `per_block` values of the measure in each.
MeasuredGames drawn_games(Measure measure, int blocks, int per_block, std::uint64_t seed,
                          const Draw& draw) {
  RandomStream random(seed);
  MeasuredGames games;
  games.start_log();
  for (int block = 0; block < blocks; ++block) {
    const double time_s = (block + 0.5) * MeasuredGames::kBlock_s;
    games.add_time(1, measure, time_s, MeasuredGames::kBlock_s);
    if (measure != Measure::kFouls)
      games.add_time(1, Measure::kFouls, time_s, MeasuredGames::kBlock_s);
    for (int i = 0; i < per_block; ++i) games.add(1, measure, time_s, draw(random));
  }
  return games;
}

const MeasureComparison& compared(const GameComparison& comparison, Measure measure) {
  return comparison.measures.at(static_cast<std::size_t>(measure));
}

TEST(GameComparison, DistributionsAreAsFarApartAsTheirSharesBelowABound) {
  const auto one = [](RandomStream& random) { return 1 + uniform(random); };
  const auto other = [](RandomStream& random) { return 1.3 + uniform(random); };
  const GameComparison comparison =
      comparison_of(drawn_games(Measure::kRobotSpeed, 100, 100, 1, one),
                    drawn_games(Measure::kRobotSpeed, 200, 100, 2, other));
  const auto& speed = compared(comparison, Measure::kRobotSpeed);
  ASSERT_TRUE(speed.distance);
  EXPECT_NEAR(speed.distance->value, 0.3, 0.03);
  EXPECT_LT(speed.distance->low, 0.3);
  EXPECT_GT(speed.distance->high, 0.3);
  EXPECT_LT(speed.distance->high - speed.distance->low, 0.06);
  EXPECT_NEAR(*speed.recorded.typical, 1.5, 0.03);
  EXPECT_NEAR(*speed.simulated.typical, 1.8, 0.03);
  EXPECT_EQ(speed.recorded.values, 10'000);
  // Nothing else was measured, so it is also the mean.
  EXPECT_EQ(comparison.compared, 1);
  ASSERT_TRUE(comparison.mean);
  EXPECT_DOUBLE_EQ(comparison.mean->value, speed.distance->value);
}

TEST(GameComparison, SharesDifferByTheirDifference) {
  const auto share = [](double probability) {
    return [probability](RandomStream& random) { return uniform(random) < probability ? 1 : 0; };
  };
  const GameComparison comparison =
      comparison_of(drawn_games(Measure::kBallUnseen, 200, 100, 1, share(0.1)),
                    drawn_games(Measure::kBallUnseen, 200, 100, 2, share(0.35)));
  const auto& unseen = compared(comparison, Measure::kBallUnseen);
  ASSERT_TRUE(unseen.distance);
  EXPECT_NEAR(unseen.distance->value, 0.25, 0.02);
  EXPECT_NEAR(*unseen.recorded.typical, 0.1, 0.01);
  EXPECT_NEAR(*unseen.simulated.typical, 0.35, 0.02);
}

TEST(GameComparison, RatesArePerMinuteAndDifferRelativeToTheirSum) {
  const auto event = [](RandomStream& /*random*/) { return 1.0; };
  const GameComparison comparison = comparison_of(drawn_games(Measure::kStops, 120, 1, 1, event),
                                                  drawn_games(Measure::kStops, 120, 3, 2, event));
  const auto& stops = compared(comparison, Measure::kStops);
  EXPECT_NEAR(*stops.recorded.typical, 12, 1e-9);
  EXPECT_NEAR(*stops.simulated.typical, 36, 1e-9);
  ASSERT_TRUE(stops.distance);
  EXPECT_NEAR(stops.distance->value, 0.5, 0.01);
}

TEST(GameComparison, EventsThatOneRecordingLacksCompletelyAreFarApart) {
  const auto event = [](RandomStream& /*random*/) { return 1.0; };
  const GameComparison comparison = comparison_of(drawn_games(Measure::kFouls, 120, 0, 1, event),
                                                  drawn_games(Measure::kFouls, 120, 1, 2, event));
  const auto& fouls = compared(comparison, Measure::kFouls);
  ASSERT_TRUE(fouls.distance);
  EXPECT_GT(fouls.distance->value, 0.9);
}

// In short recordings, chance alone makes a difference of 0.1 to 0.2.
TEST(GameComparison, AlikeGamesAreRarelyApartEvenIfShort) {
  constexpr int kTrials = 40;
  int apart = 0;
  double sum = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const GameComparison comparison =
        comparison_of(drawn_games(Measure::kRobotSpeed, 8, 5, 2 * trial + 1, uniform),
                      drawn_games(Measure::kRobotSpeed, 30, 5, 2 * trial + 2, uniform));
    const auto& distance = compared(comparison, Measure::kRobotSpeed).distance;
    ASSERT_TRUE(distance);
    apart += distance->low > 0 ? 1 : 0;
    sum += distance->value;
  }
  EXPECT_LE(apart, 3);
  EXPECT_LT(sum / kTrials, 0.08);
}

// A log with stops has blocks without running play, a clip cut down to play has none.
TEST(GameComparison, DoesNotDependOnBlocksWithoutPlay) {
  const MeasuredGames clip = drawn_games(Measure::kRobotSpeed, 12, 10, 1, uniform);
  const auto other = [](RandomStream& random) { return 0.2 + uniform(random); };
  MeasuredGames games = drawn_games(Measure::kRobotSpeed, 40, 10, 2, other);
  const GameComparison dense = comparison_of(clip, games);
  for (int block = 40; block < 400; ++block)
    games.add(1, Measure::kInPlay, (block + 0.5) * MeasuredGames::kBlock_s, 0);
  const GameComparison sparse = comparison_of(clip, games);
  const auto& distance = compared(dense, Measure::kRobotSpeed).distance;
  const auto& same = compared(sparse, Measure::kRobotSpeed).distance;
  ASSERT_TRUE(distance && same);
  EXPECT_NEAR(distance->value, same->value, 0.02);
}

TEST(GameComparison, IntervalsContainTheTruth) {
  constexpr int kTrials = 40;
  const auto other = [](RandomStream& random) { return 0.4 + uniform(random); };
  int missed = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    const GameComparison comparison =
        comparison_of(drawn_games(Measure::kRobotSpeed, 12, 10, 2 * trial + 1, uniform),
                      drawn_games(Measure::kRobotSpeed, 40, 10, 2 * trial + 2, other));
    const auto& distance = compared(comparison, Measure::kRobotSpeed).distance;
    ASSERT_TRUE(distance);
    EXPECT_LT(distance->high - distance->low, 0.35);
    missed += distance->low > 0.4 || distance->high < 0.4 ? 1 : 0;
  }
  EXPECT_LE(missed, 6);
}

TEST(GameComparison, SaysIfThereIsTooLittle) {
  const MeasuredGames many = drawn_games(Measure::kRobotSpeed, 20, 5, 1, uniform);
  for (const MeasuredGames& few :
       {drawn_games(Measure::kRobotSpeed, 20, 0, 2, uniform),
        drawn_games(Measure::kRobotSpeed, 3, 50, 2, uniform),
        drawn_games(Measure::kRobotSpeed, 9, 1, 2, uniform), MeasuredGames{}}) {
    const GameComparison comparison = comparison_of(many, few);
    EXPECT_FALSE(compared(comparison, Measure::kRobotSpeed).distance);
    EXPECT_FALSE(comparison.mean);
    EXPECT_EQ(comparison.compared, 0);
  }
}

TEST(GameComparison, IsReproducible) {
  const MeasuredGames one = drawn_games(Measure::kRobotSpeed, 20, 5, 1, uniform);
  const MeasuredGames other = drawn_games(Measure::kRobotSpeed, 30, 5, 2, uniform);
  const GameComparison first = comparison_of(one, other);
  const GameComparison second = comparison_of(one, other);
  ASSERT_TRUE(first.mean && second.mean);
  EXPECT_EQ(first.mean->low, second.mean->low);
  EXPECT_EQ(first.mean->high, second.mean->high);
}

}  // namespace
}  // namespace autoref::logs
