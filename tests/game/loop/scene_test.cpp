// Scenes: start states, and what ends and scores them.
#include "game/loop/start_scene.hpp"

#include <gtest/gtest.h>

#include "game/loop/game.hpp"
#include "tests/support/short_game.hpp"

namespace autoref::game {
namespace {

// Two teams that stand still, a ball that rolls towards the empty goal in the east, and two robots
// far from it.
GameConfiguration rolling_ball() {
  GameConfiguration game = short_game(600, 3);
  game.a.strategy = game.b.strategy = "dummy";
  game.scene = Scene{};
  game.start = StartState{};
  game.start->ball = {{2, 0.1}, {3, 0}, 0, 0, true};
  game.start->robots[Side::kWest] = {sim::RobotState{.number = 2, .position_m = {-1, 1}}};
  game.start->robots[Side::kEast] = {
      sim::RobotState{.number = 0, .position_m = {0, -1}, .heading = {0, 1}}};
  return game;
}

GameConfiguration turned_round(GameConfiguration game) {
  game.start = mirrored(*game.start);
  game.match.a_plays = opponent_of(game.match.a_plays);
  return game;
}

TEST(Scene, StartsWithTheRobotsAndTheBallWhereTheyAreSaidToBe) {
  const Game game(rolling_ball());
  const sim::WorldState& world = game.world().state();
  ASSERT_EQ(world.robots[Side::kWest].size(), 1U);
  EXPECT_EQ(world.robots[Side::kWest][0].number, 2);
  EXPECT_NEAR((world.robots[Side::kWest][0].position_m - Vec2(-1, 1)).norm(), 0, 1e-6);
  ASSERT_EQ(world.robots[Side::kEast].size(), 1U);
  EXPECT_NEAR((world.ball.position_m - Vec2(2, 0.1)).norm(), 0, 1e-6);
  EXPECT_NEAR((world.ball.velocity_mps - Vec2(3, 0)).norm(), 0, 1e-6);
}

TEST(Scene, WithABallRollingIntoAnEmptyGoalScoresOne) {
  const GameRecord record = play(rolling_ball());
  ASSERT_TRUE(record.scene);
  EXPECT_EQ(record.scene->ended_by, SceneEnd::kGoal);
  EXPECT_EQ(record.scene->score, 1);
  EXPECT_TRUE(record.scene->ball_kept);
  EXPECT_NEAR(record.scene->gained_m, 1.05, 0.15);
  EXPECT_EQ(record.goals_a, 1);
  EXPECT_LT(record.sim_s, 1.5);
}

TEST(Scene, HasTheSameOutcomeFromTheOtherSide) {
  const GameRecord record = play(turned_round(rolling_ball()));
  EXPECT_EQ(record.scene->ended_by, SceneEnd::kGoal);
  EXPECT_EQ(record.scene->score, 1);
  EXPECT_NEAR(record.scene->gained_m, 1.05, 0.15);
}

TEST(Scene, CountsAGoalOfTheDefendersOnlyWithAWeight) {
  GameConfiguration game = rolling_ball();
  game.match.a_plays = Side::kEast;
  EXPECT_EQ(play(game).scene->score, 0);
  game.scene->weights = {1, -2, 0, 0};
  const GameRecord record = play(game);
  EXPECT_EQ(record.scene->score, -2);
  EXPECT_FALSE(record.scene->ball_kept);
  EXPECT_LT(record.scene->gained_m, -0.9);
}

TEST(Scene, LastsItsSecondsIfNothingEndsIt) {
  GameConfiguration game = rolling_ball();
  game.start->ball.velocity_mps = {0.1, 0};
  game.scene->lasts_s = 2.5;
  const GameRecord record = play(game);
  EXPECT_EQ(record.scene->ended_by, SceneEnd::kTime);
  EXPECT_EQ(record.scene->score, 0);
  EXPECT_NEAR(record.sim_s, 2.5, 0.05);
}

TEST(Scene, EndsWhenTheBallGoesOut) {
  GameConfiguration game = rolling_ball();
  game.start->ball = {{0, 1.5}, {0, 3}, 0, 0, true};
  EXPECT_EQ(play(game).scene->ended_by, SceneEnd::kBallOut);
}

TEST(Scene, ContinuesAfterWhatDoesNotEndIt) {
  GameConfiguration game = rolling_ball();
  game.start->ball = {{0, 1.5}, {0, 3}, 0, 0, true};
  game.scene->ends[static_cast<std::size_t>(SceneEnd::kBallOut)] = false;
  game.scene->lasts_s = 3;
  const GameRecord record = play(game);
  EXPECT_EQ(record.scene->ended_by, SceneEnd::kTime);
  EXPECT_EQ(record.events[static_cast<std::size_t>(referee::Event::kTouchLineUnknown)], 1);
}

// A robot that is not in the start state stays off the field, also in a stop.
TEST(Scene, KeepsTheOtherRobotsOff) {
  GameConfiguration game = rolling_ball();
  game.start->ball = {{0, 0}, {0, 0}, 0, 0, true};
  game.start->referee = {Command{CommandKind::kDirectFree, Side::kWest}, {0, 0}, true};
  Game played(game);
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(played.step());
  EXPECT_EQ(played.world().state().robots[Side::kWest].size(), 1U);
  EXPECT_EQ(played.world().state().robots[Side::kEast].size(), 1U);
}

struct StartedRestart {
  const char* name;
  CommandKind restart;
  bool is_stopped;
  std::vector<CommandKind> commands;  // until play begins
};

class SceneRestart : public testing::TestWithParam<StartedRestart> {};

std::vector<Command> commands_until_play(Game& game) {
  std::vector<Command> commands;
  for (int i = 0; i < 60 * 60; ++i) {
    if (!game.step()) break;
    if (commands.empty() || !(commands.back() == game.signal().command))
      commands.push_back(game.signal().command);
    if (!game.signal().placement && !game.signal().next_command) break;
  }
  return commands;
}

TEST_P(SceneRestart, IsGivenToItsTeamAtItsPlace) {
  GameConfiguration game = rolling_ball();
  const Vec2 position_m =
      GetParam().restart == CommandKind::kPrepareKickoff ? Vec2(0, 0) : Vec2(1.5, 0.5);
  game.start->ball = {position_m, {0, 0}, 0, 0, true};
  game.start->referee = {Command{GetParam().restart, Side::kEast}, position_m,
                         GetParam().is_stopped};
  Game played(game);
  const std::vector<Command> commands = commands_until_play(played);
  ASSERT_EQ(commands.size(), GetParam().commands.size());
  for (std::size_t i = 0; i < commands.size(); ++i) {
    EXPECT_EQ(commands[i].kind, GetParam().commands[i]);
    EXPECT_TRUE(!is_for_one_side(commands[i].kind) || commands[i].side == Side::kEast);
  }
  EXPECT_NEAR((played.world().state().ball.position_m - position_m).norm(), 0, 0.01);
  EXPECT_EQ(played.signal().stage, Stage::kFirstHalf);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, SceneRestart,
    testing::Values(
        StartedRestart{"free_kick", CommandKind::kDirectFree, false, {CommandKind::kDirectFree}},
        StartedRestart{"free_kick_after_stop",
                       CommandKind::kDirectFree,
                       true,
                       {CommandKind::kStop, CommandKind::kDirectFree}},
        StartedRestart{"indirect", CommandKind::kIndirectFree, false, {CommandKind::kIndirectFree}},
        StartedRestart{"force_start", CommandKind::kForceStart, false, {CommandKind::kForceStart}},
        StartedRestart{"kickoff",
                       CommandKind::kPrepareKickoff,
                       false,
                       {CommandKind::kPrepareKickoff, CommandKind::kNormalStart}},
        StartedRestart{
            "penalty_after_stop",
            CommandKind::kPreparePenalty,
            true,
            {CommandKind::kStop, CommandKind::kPreparePenalty, CommandKind::kNormalStart}}),
    [](const auto& test) { return std::string(test.param.name); });

// The seconds of a scene count from the start of play, not of the stop before it.
TEST(Scene, CountsItsSecondsFromTheStartOfPlay) {
  GameConfiguration game = rolling_ball();
  game.start->ball = {{0, 0}, {0, 0}, 0, 0, true};
  game.start->referee = {Command{CommandKind::kForceStart, Side::kWest}, {0, 0}, true};
  game.scene->lasts_s = 1;
  const GameRecord record = play(game);
  EXPECT_EQ(record.scene->ended_by, SceneEnd::kTime);
  EXPECT_NEAR(record.ball_in_play_s, 1, 0.05);
  EXPECT_GT(record.sim_s, 1.9);
}

TEST(Scene, KeepsTheBallIfItsOwnTeamTakesTheNextRestart) {
  GameConfiguration game = rolling_ball();
  // A defender's hull deflects the ball over the touch line.
  game.start->robots[Side::kEast][0].position_m = {0.09, 1.8};
  game.start->ball = {{0, 1.5}, {0, 3}, 0, 0, true};
  const GameRecord record = play(game);
  ASSERT_EQ(record.scene->ended_by, SceneEnd::kBallOut);
  EXPECT_TRUE(record.scene->ball_kept);
}

TEST(Game, RefusesAStartStateWithARobotThatItsTeamLacks) {
  GameConfiguration game = rolling_ball();
  game.start->robots[Side::kWest][0].number = 6;
  EXPECT_THROW(Game{game}, std::invalid_argument);
}

}  // namespace
}  // namespace autoref::game
