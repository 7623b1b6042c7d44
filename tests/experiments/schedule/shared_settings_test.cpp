#include "experiments/schedule/schedule.hpp"

#include <gtest/gtest.h>

#include "experiments/kinds/roundrobin/roundrobin.hpp"
#include "experiments/schedule/matchup_schedule.hpp"
#include "game/settings/fields.hpp"

namespace autoref::experiments {
namespace {

game::GameSettings some_game() {
  game::GameSettings game;
  game.a.robots = 5;
  game.b.strategy = "zone";
  game.match.half_s = 60;
  game.match.a_plays = Side::kEast;
  game.seed = 7;
  game.given = {"match.half_s"};
  return game;
}

TEST(SharedSettings, AreTheWholeSettings) {
  const game::GameSettings whole = SharedSettings(some_game()).combined();
  EXPECT_EQ(game::configuration_hash(whole), game::configuration_hash(some_game()));
  EXPECT_EQ(whole.match.a_plays, Side::kEast);
  EXPECT_EQ(whole.seed, 7U);
  EXPECT_TRUE(whole.given.empty());
}

TEST(SharedSettings, DifferInTeamsAndLeg) {
  const SharedSettings shared(some_game());
  game::TeamSettings strong;
  strong.robots = 8;
  const SharedSettings other = shared
                                   .between(std::make_shared<const game::TeamSettings>(strong),
                                            std::make_shared<const game::TeamSettings>(shared.b()))
                                   .with({Side::kWest, Side::kEast, 9});
  game::GameSettings expected = some_game();
  expected.a = strong;
  expected.match.a_plays = Side::kWest;
  expected.match.first_kickoff = Side::kEast;
  expected.seed = 9;
  EXPECT_EQ(game::configuration_hash(other.combined()), game::configuration_hash(expected));
  EXPECT_EQ(game::configuration_hash(shared.combined()), game::configuration_hash(some_game()));
}

TEST(SharedSettings, TurnTheStartOfASceneIfTeamAPlaysInTheEast) {
  game::StartState start;
  start.ball.position_m = {1, 2};
  const SharedSettings scene =
      SharedSettings(some_game()).starting_from(std::make_shared<const game::StartState>(start));
  EXPECT_EQ(scene.with({Side::kWest, Side::kWest, 1}).combined().start->ball.position_m.x(), 1);
  EXPECT_EQ(scene.with({Side::kEast, Side::kWest, 1}).combined().start->ball.position_m.x(), -1);
}

// Else a tournament of many teams needs memory for the settings of all teams in each of its games.
TEST(SharedSettings, OfATeamAreTheSameObjectInAllItsGames) {
  RoundRobin robin;
  for (const char* name : {"a", "b", "c"}) robin.teams[name].robots = 3;
  const std::vector<ScheduledGame> games = robin.games();
  ASSERT_EQ(games.size(), 6U);
  EXPECT_EQ(&games[0].settings.a(), &games[2].settings.a());  // a~b and a~c
  EXPECT_EQ(&games[2].settings.b(), &games[4].settings.b());  // a~c and b~c
  EXPECT_LE(sizeof(ScheduledGame), 320U);
}

}  // namespace
}  // namespace autoref::experiments
