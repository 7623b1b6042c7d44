// Whole games under the noisiest vision and radio.
#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "sim/presets.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

GameConfiguration realistic_game(double half_s, std::uint64_t seed) {
  GameConfiguration game = short_game(half_s, seed);
  sim::apply_camera_preset("realistic", game.sim);
  return game;
}

// In 100 games of 20 minutes, there were 3.1 goals per game on average and at most 8, and the ball
// was in play for 53 % of the time.
TEST(RealisticGame, EndsWithAPlausibleScore) {
  int goals = 0;
  double in_play_s = 0;
  double played_s = 0;
  for (std::uint64_t seed = 1; seed <= AUTOREF_REALISTIC_GAMES; ++seed) {
    const GameRecord record = play(realistic_game(600, seed));
    ASSERT_EQ(record.status, Status::kOk) << record.void_reason;
    EXPECT_LE(record.goals_a + record.goals_b, 10) << seed;
    goals += record.goals_a + record.goals_b;
    in_play_s += record.ball_in_play_s;
    played_s += record.sim_s;
  }
  EXPECT_GT(goals, 0);
  EXPECT_GT(in_play_s, 0.35 * played_s);
}

TEST(RealisticGame, IsIdenticalForTheSameSeedAndDiffersForAnother) {
  const std::uint64_t first = play(realistic_game(20, 1)).state_hash;
  EXPECT_EQ(play(realistic_game(20, 1)).state_hash, first);
  EXPECT_NE(play(realistic_game(20, 2)).state_hash, first);
}

}  // namespace
}  // namespace autoref::game
