// The strong team plays short games with 1 to 16 robots, and with robots missing.
#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

// Both teams' sizes: together 17, so that every size meets another one.
class TeamSizes : public testing::TestWithParam<int> {};

GameConfiguration game_of(const char* rules, int robots_a, int robots_b) {
  GameConfiguration game = short_game_by(rules, 8, 1);
  game.a.strategy = "cobalt";
  game.b.strategy = "cobalt";
  game.a.robots.resize(static_cast<std::size_t>(robots_a));
  game.b.robots.resize(static_cast<std::size_t>(robots_b));
  return game;
}

TEST_P(TeamSizes, PlaysAGameInWhichEveryRestartIsTaken) {
  for (const char* rules : {"paper", "2026-b"}) {
    const GameRecord record = play(game_of(rules, GetParam(), 17 - GetParam()));
    EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
    EXPECT_EQ(record.events[static_cast<int>(referee::Event::kRestartNotTaken)], 0) << rules;
  }
}

INSTANTIATE_TEST_SUITE_P(OfCobalt, TeamSizes, testing::Range(1, 17));

TEST(DivisionA, PlaysElevenAgainstEleven) {
  GameConfiguration game = game_of("2026-a", 11, 11);
  game.match.half_s = 20;
  const GameRecord record = play(game);
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_GT(record.ball_in_play_s, 0.25 * record.sim_s);
}

TEST(TeamCobalt, ScoresMoreThanThePreviousVersionIfItMayDribble) {
  GameConfiguration game = short_game_by("paper", 400, 1);
  game.a.strategy = "cobalt";
  game.b.strategy = "cobalt1";
  for (TeamConfiguration* team : {&game.a, &game.b}) team->laws.reset();
  const GameRecord record = play(game);
  EXPECT_GT(record.goals_a, record.goals_b);
}

}  // namespace
}  // namespace autoref::game
