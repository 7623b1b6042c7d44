// Whole games of `rowdy`.
#include <gtest/gtest.h>

#include "tests/game/loop/foul_behaviour.hpp"

namespace autoref::game {
namespace {

GameConfiguration rowdy_game(double half_s) {
  GameConfiguration game;
  game.match.half_s = half_s;
  game.a.strategy = game.b.strategy = "rowdy";
  return game;
}

TEST(Rowdy, PlaysGamesThatEnd) {
  for (const double share : {0.1, 1.0}) {
    GameConfiguration game = rowdy_game(60);
    game.a.params = game.b.params = {{"otherwise", share}};
    const GameRecord record = play(game);
    EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
    EXPECT_EQ(record.end_reason, EndReason::kTime);
  }
}

TEST(Rowdy, WithoutFoulsPlaysLikeBasic) {
  GameConfiguration game = rowdy_game(30);
  game.a.params = game.b.params = {{"otherwise", 0}};
  const std::uint64_t hash = play(game).state_hash;
  game.a = game.b = TeamConfiguration{};
  EXPECT_EQ(play(game).state_hash, hash);
}

}  // namespace
}  // namespace autoref::game
