// Every team that plays by the rules plays a short full game.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "game/loop/game.hpp"
#include "tests/strategies/lawful_teams.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

class EveryTeam : public testing::TestWithParam<std::string_view> {};

GameConfiguration game_against(std::string_view team, const std::string& other) {
  GameConfiguration game = short_game(120, 1);
  game.a.strategy = team;
  game.b.strategy = other;
  return game;
}

TEST_P(EveryTeam, PlaysAGameInWhichEveryRestartIsTaken) {
  const GameRecord record = play(game_against(GetParam(), "basic"));
  ASSERT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_EQ(record.end_reason, EndReason::kTime);
  EXPECT_EQ(record.events[static_cast<int>(referee::Event::kRestartNotTaken)], 0);
}

TEST_P(EveryTeam, KeepsTheBallInPlayMostOfTheTimeByStandingStillInStops) {
  const GameRecord record = play(game_against(GetParam(), "basic"));
  EXPECT_GT(record.ball_in_play_s, 0.3 * record.sim_s);
}

TEST_P(EveryTeam, BeatsDummy) {
  const GameRecord record = play(game_against(GetParam(), "dummy"));
  EXPECT_GT(record.goals_a, 0);
  EXPECT_EQ(record.goals_b, 0);
}

INSTANTIATE_TEST_SUITE_P(Teams, EveryTeam, testing::ValuesIn(strategies::lawful_teams()),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace autoref::game
