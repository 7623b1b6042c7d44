#include "experiments/kinds/situations/situations.hpp"

#include <gtest/gtest.h>

#include "game/settings/fields.hpp"
#include "tests/experiments/kinds/situations/small_situations.hpp"

namespace autoref::experiments {
namespace {

std::vector<ScheduledGame> small_schedule() { return situations_in(small_situations()).games(); }

const ScheduledGame& scheduled_scene(const std::vector<ScheduledGame>& games,
                                     const std::string& id) {
  for (const ScheduledGame& game : games) {
    if (game.id == id) return game;
  }
  throw std::out_of_range(id);
}

TEST(SituationsSchedule, PlaysEverySituationWithEveryTeamInTwoLegs) {
  const std::vector<ScheduledGame> games = small_schedule();
  ASSERT_EQ(games.size(), 16U);
  EXPECT_EQ(games[0].id, "goal+one~still-p0001-1");
  EXPECT_EQ(games[1].id, "goal+one~still-p0001-2");
  EXPECT_EQ(games[2].id, "rest+two~still-p0001-1");
  EXPECT_EQ(games[15].id, "rest+one~still-p0002-2");
  EXPECT_EQ(games[0].unit, games[1].unit);
  EXPECT_EQ(games[15].values, std::vector<std::string>{"rest"});
}

TEST(SituationsSchedule, TurnsTheStartStateInTheSecondLeg) {
  const std::vector<ScheduledGame> games = small_schedule();
  const game::StartState first = *games[0].settings.combined().start;
  const game::StartState second = *games[1].settings.combined().start;
  EXPECT_EQ(games[0].settings.combined().match.a_plays, Side::kWest);
  EXPECT_EQ(games[1].settings.combined().match.a_plays, Side::kEast);
  EXPECT_EQ(first.ball.velocity_mps, Vec2(3, 0));
  EXPECT_EQ(second.ball.position_m, Vec2(-first.ball.position_m));
  EXPECT_EQ(second.robots[Side::kEast].size(), 2U);
}

TEST(SituationsSchedule, GivesAllTeamsTheSameStatesAndSeeds) {
  const std::vector<ScheduledGame> games = small_schedule();
  const game::GameSettings one =
      scheduled_scene(games, "goal+one~still-p0002-1").settings.combined();
  const game::GameSettings two =
      scheduled_scene(games, "goal+two~still-p0002-1").settings.combined();
  EXPECT_EQ(one.start->ball.position_m, two.start->ball.position_m);
  EXPECT_EQ(one.start->robots[Side::kEast][0].position_m,
            two.start->robots[Side::kEast][0].position_m);
  EXPECT_EQ(one.seed, two.seed);
}

TEST(SituationsSchedule, ChangesNoGameIfSituationsTeamsOrPairsAreAdded) {
  Situations situations = situations_in(small_situations());
  const std::vector<ScheduledGame> before = situations.games();
  situations.situations["another"] = situations.situations.at("rest");
  situations.attackers["another"] = situations.attackers.at("one");
  situations.pairs = 3;
  const std::vector<ScheduledGame> after = situations.games();
  for (const ScheduledGame& game : before) {
    EXPECT_EQ(game::configuration_hash(game.settings.combined()),
              game::configuration_hash(scheduled_scene(after, game.id).settings.combined()));
  }
}

TEST(ConfigurationHash, CoversTheStartStateAndTheScene) {
  const game::GameSettings game = small_schedule().front().settings.combined();
  game::GameSettings other = game;
  other.start->robots[Side::kWest][0].position_m.x() += 0.001;
  EXPECT_NE(game::configuration_hash(other), game::configuration_hash(game));
  other = game;
  other.start->referee.restart = Command{CommandKind::kDirectFree, Side::kWest};
  EXPECT_NE(game::configuration_hash(other), game::configuration_hash(game));
  other = game;
  other.scene->lasts_s = 3;
  EXPECT_NE(game::configuration_hash(other), game::configuration_hash(game));
}

}  // namespace
}  // namespace autoref::experiments
