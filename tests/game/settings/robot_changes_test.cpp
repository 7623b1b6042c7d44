// The final values of each robot.
#include "game/settings/robot_types.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "experiments/kinds/scenario.hpp"
#include "experiments/kinds/scenario_reader.hpp"

namespace autoref::game {
namespace {

const std::string kChangesGame = "schema: 1\nkind: game\n";

GameSettings game_of_changes(const std::string& text) {
  return std::get<GameSettings>(
      experiments::read_scenario_text(kChangesGame + text, "x.yaml").content);
}

sim::RobotSpec robot_of_b(const std::string& text, std::size_t number) {
  const GameSettings game = game_of_changes(text);
  return spec_of(game, game.b, "teams.b").robots.at(number);
}

TEST(SpecOf, GivesEveryRobotTheGamesValuesByDefault) {
  const GameSettings game = game_of_changes("sim: { robot: { speed_mps: 2.5 } }\n");
  for (const TeamSettings* team : {&game.a, &game.b}) {
    const sim::TeamSpec spec = spec_of(game, *team, "teams.x");
    ASSERT_EQ(spec.robots.size(), 6U);
    for (const sim::RobotSpec& robot : spec.robots) {
      EXPECT_EQ(robot.body.speed_mps, 2.5);
      EXPECT_EQ(robot.body.mass_kg, 2.5);
      EXPECT_EQ(robot.speed_factor, 1.0);
    }
  }
}

// In order of increasing priority, each layer sets one value fewer than the one before, so every
// layer decides exactly one value.
TEST(SpecOf, LetsTeamsOverrideTheGameAndPlayersOverrideTeamsInAnyOrderOfKeys) {
  const std::string types =
      "types:\n"
      "  team: { robot: { braking_mps2: 12, acceleration_mps2: 12, speed_mps: 12, mass_kg: 12 } }\n"
      "  player: { robot: { speed_mps: 14, mass_kg: 14 } }\n";
  const std::string sim =
      "sim: { robot: { wheel_acceleration_mps2: 11, braking_mps2: 11, acceleration_mps2: 11,\n"
      "                speed_mps: 11, mass_kg: 11 } }\n";
  const std::string teams =
      "teams:\n"
      "  b:\n"
      "    players: { 2: { robot: { mass_kg: 15 }, type: player } }\n"
      "    robot: { acceleration_mps2: 13, speed_mps: 13, mass_kg: 13 }\n"
      "    type: team\n";
  for (const std::string& text : {types + sim + teams, teams + sim + types}) {
    const sim::RobotParameters robot = robot_of_b(text, 2).body;
    EXPECT_EQ(robot.wheel_acceleration_mps2, 11);  // set by the game
    EXPECT_EQ(robot.braking_mps2, 12);             // set by the team's type
    EXPECT_EQ(robot.acceleration_mps2, 13);        // set by the team
    EXPECT_EQ(robot.speed_mps, 14);                // set by the player's type
    EXPECT_EQ(robot.mass_kg, 15);                  // set by the player
    EXPECT_EQ(robot_of_b(text, 3).body.mass_kg, 13);
  }
}

TEST(SpecOf, DoesNotAffectTheOtherTeam) {
  const GameSettings game =
      game_of_changes("teams: { b: { robot: { mass_kg: 3 }, handicap: 0.5 } }\n");
  EXPECT_EQ(spec_of(game, game.a, "teams.a").robots[0].body.mass_kg, 2.5);
  EXPECT_EQ(spec_of(game, game.a, "teams.a").robots[0].speed_factor, 1.0);
  EXPECT_EQ(spec_of(game, game.b, "teams.b").robots[5].body.mass_kg, 3.0);
}

TEST(SpecOf, MultipliesTheTeamsFactorsWithThePlayers) {
  const std::string text =
      "teams: { b: { speed_factor: 0.8, players: { 3: { handicap: 0.5 }, 4: { "
      "acceleration_factor: 0.7 } } } }\n";
  EXPECT_DOUBLE_EQ(robot_of_b(text, 3).speed_factor, 0.4);
  EXPECT_DOUBLE_EQ(robot_of_b(text, 3).acceleration_factor, 0.5);
  EXPECT_DOUBLE_EQ(robot_of_b(text, 4).speed_factor, 0.8);
  EXPECT_DOUBLE_EQ(robot_of_b(text, 4).acceleration_factor, 0.7);
  EXPECT_DOUBLE_EQ(robot_of_b(text, 5).speed_factor, 0.8);
}

TEST(SpecOf, LetsSingleSettingsOverrideADribblersPresetInAnyOrder) {
  const sim::RobotSpec robot =
      robot_of_b("teams: { b: { dribbler: { force_n: 50, preset: perfect } } }\n", 0);
  EXPECT_TRUE(robot.dribbler.holds);
  EXPECT_EQ(robot.dribbler.force_n, 50);
}

TEST(SpecOf, AlsoChangesKickers) {
  const std::string text = "teams: { b: { players: { 1: { kicker: { speed_limit_mps: 5 } } } } }\n";
  EXPECT_EQ(robot_of_b(text, 1).kicker.speed_limit_mps, 5);
  EXPECT_EQ(robot_of_b(text, 0).kicker.speed_limit_mps, 8);
}

TEST(SpecOf, RefusesAPlayerThatTheTeamDoesNotHave) {
  GameSettings game;
  game.b.players[6].speed_factor = 0.5;
  EXPECT_THROW(spec_of(game, game.b, "teams.b"), std::invalid_argument);
}

TEST(SpecOf, RefusesATypeThatTheGameDoesNotHave) {
  GameSettings game;
  game.a.type = "slow";
  EXPECT_THROW(spec_of(game, game.a, "teams.a"), std::invalid_argument);
}

TEST(RobotChanges, DoNotKeepAnInvalidValue) {
  GameSettings game;
  EXPECT_THROW(set_by_path(game, "a.robot.mass_kg", "-1"), std::invalid_argument);
  EXPECT_TRUE(game.a.changes.empty());
}

TEST(RobotChanges, AreNumbersAndWords) {
  GameSettings game;
  set_by_path(game, "a.robot.mass_kg", "2.50");
  set_by_path(game, "a.dribbler.holds", "true");
  const RobotChanges expected = {{"robot.mass_kg", 2.5}, {"dribbler.holds", "true"}};
  EXPECT_EQ(game.a.changes, expected);
}

}  // namespace
}  // namespace autoref::game
