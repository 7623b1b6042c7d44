#include "benchmarks/experiment_costs.hpp"

#include <gtest/gtest.h>

#include "game/loop/game.hpp"

namespace autoref::benchmarks {
namespace {

RunCosts some_costs() {
  RunCosts costs;
  costs.worker.games = 4;
  costs.worker.frames = 600;
  costs.worker.frames_s = 2.7;
  costs.parent_s = 0.2;
  costs.workers_s = 2.8;
  costs.waits = 6;
  return costs;
}

TEST(RunCosts, OverheadIsEverythingOutsideTheFrames) {
  EXPECT_NEAR(some_costs().overhead(), 0.1, 1e-12);
}

TEST(RunCosts, SpeedCountsTheTimeOfAllProcesses) {
  EXPECT_NEAR(some_costs().frames_per_s(), 200, 1e-9);
  EXPECT_NEAR(some_costs().total_s_per_game(), 0.75, 1e-12);
  EXPECT_NEAR(some_costs().waits_per_game(), 1.5, 1e-12);
}

TEST(MeasuredRatio, IsTheMedianWithItsInterval) {
  const MeasuredRatio ratio = measured_ratio({6, 1, 5, 2, 4, 3});
  EXPECT_DOUBLE_EQ(ratio.median, 4);
  EXPECT_DOUBLE_EQ(ratio.interval.low, 1);
  EXPECT_DOUBLE_EQ(ratio.interval.high, 6);
}

// Sums, not times, so the test does not depend on the machine's speed.
TEST(RunCosts, ComeFromTheGamesOfAllWorkers) {
  const RunCosts costs = costs_of({.pairs = 2, .half_s = 1, .workers = 3, .with_memory = true});
  EXPECT_EQ(costs.worker.games, 4);
  EXPECT_GT(costs.worker.frames, 4 * 120);  // two halves of 60 frames each, and the stops
  EXPECT_GT(costs.worker.frames_s, 0);
  EXPECT_GT(costs.worker.set_up_s, 0);
  EXPECT_GE(costs.workers_s, costs.worker.frames_s);
  EXPECT_GT(costs.parent_s, 0);
  EXPECT_GT(costs.worker.most_private_mb, 0);
  EXPECT_GT(costs.worker.most_resident_mb, costs.worker.most_private_mb);
}

TEST(WorkerMeter, PlaysTheSameGameAsPlay) {
  game::GameConfiguration game;
  game.match.half_s = 1;
  const WorkerMeter meter;
  const game::GameRecord record = meter.play(game, false);
  EXPECT_EQ(record.state_hash, game::play(game).state_hash);
  EXPECT_EQ(meter.costs().frames, record.frames);
}

}  // namespace
}  // namespace autoref::benchmarks
