// The teams in strategies/README.md can play, so code copied from there works.
#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "tests/strategies/readme_team.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

std::unique_ptr<strategies::Strategy> make_team(const TeamConfiguration& team,
                                                const strategies::TeamContext& context) {
  using namespace strategies;
  if (team.strategy == "mine") return std::make_unique<readme::Mine>(context);
  if (team.strategy == "bus") return std::make_unique<Squad>(context, readme::bus_playbook());
  return make_registered_team(team, context);
}

GameRecord played_by(const std::string& team) {
  GameConfiguration game = short_game(60, 1);
  game.a.strategy = team;
  game.b.strategy = "dummy";
  return play(game, nullptr, make_team);
}

TEST(ReadmeTeam, ScoresAgainstDummy) {
  const GameRecord record = played_by("mine");
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_GT(record.goals_a, 0);
}

TEST(ReadmePlaybook, ScoresAgainstDummy) {
  const GameRecord record = played_by("bus");
  EXPECT_EQ(record.status, Status::kOk) << record.void_reason;
  EXPECT_GT(record.goals_a, 0);
}

}  // namespace
}  // namespace autoref::game
