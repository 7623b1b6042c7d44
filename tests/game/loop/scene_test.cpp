// Scenes: start states, and what ends and scores them.
#include "game/loop/start_scene.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "game/loop/game.hpp"
#include "game/loop/team_controller.hpp"
#include "soccer/team_view.hpp"
#include "strategies/strategy.hpp"
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

// West has a goal, a foul, a card and a named keeper, and takes the next free kick.
RefereeSignal signal_with_west_ahead() {
  RefereeSignal signal;
  signal.command = {CommandKind::kStop, Side::kWest};
  signal.next_command = Command{CommandKind::kDirectFree, Side::kWest};
  signal.placement = Placement{{1, -0.5}};
  signal.goals = {{3, 1}};
  signal.shootout_goals = {{2, 0}};
  signal.robots_allowed = {{5, 6}};
  signal.yellow_cards = {{1, 0}};
  signal.red_cards = {{2, 1}};
  signal.yellow_left_s[Side::kWest] = {30, 90};
  signal.fouls = {{2, 0}};
  signal.timeouts_left = {{3, 4}};
  signal.timeout_left_s = {{120, 300}};
  signal.keepers[Side::kWest] = 5;
  signal.can_place_ball = {{false, true}};
  return signal;
}

TEST(MirroredStartState, GivesEverythingOfASideInTheSignalToTheOther) {
  StartState state;
  state.referee.signal = signal_with_west_ahead();
  state.referee.goals_in_earlier_halves = {{2, 1}};
  const StartState other = mirrored(state);
  const RefereeSignal& signal = *other.referee.signal;
  EXPECT_EQ(other.referee.goals_in_earlier_halves, (PerSide<int>{{1, 2}}));
  EXPECT_EQ(signal.goals, (PerSide<int>{{1, 3}}));
  EXPECT_EQ(signal.shootout_goals, (PerSide<int>{{0, 2}}));
  EXPECT_EQ(signal.robots_allowed, (PerSide<int>{{6, 5}}));
  EXPECT_EQ(signal.yellow_cards, (PerSide<int>{{0, 1}}));
  EXPECT_EQ(signal.red_cards, (PerSide<int>{{1, 2}}));
  EXPECT_TRUE(signal.yellow_left_s[Side::kWest].empty());
  EXPECT_EQ(signal.yellow_left_s[Side::kEast], state.referee.signal->yellow_left_s[Side::kWest]);
  EXPECT_EQ(signal.fouls, (PerSide<int>{{0, 2}}));
  EXPECT_EQ(signal.timeouts_left, (PerSide<int>{{4, 3}}));
  EXPECT_EQ(signal.timeout_left_s, (PerSide<double>{{300, 120}}));
  EXPECT_EQ(signal.keepers[Side::kWest], std::nullopt);
  EXPECT_EQ(signal.keepers[Side::kEast], 5);
  EXPECT_EQ(signal.can_place_ball, (PerSide<bool>{{true, false}}));
}

// The team that wore yellow now wears blue, but its end of the real field is the same.
TEST(MirroredStartState, KeepsTheTeamsEndsAndTurnsTheCommands) {
  StartState state;
  state.referee.signal = signal_with_west_ahead();
  const RefereeSignal signal = *mirrored(state).referee.signal;
  EXPECT_FALSE(signal.blue_on_positive_half);
  EXPECT_EQ(signal.command, (Command{CommandKind::kStop, Side::kWest}));
  EXPECT_EQ(signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_EQ(signal.placement->target_m, Vec2(-1, 0.5));
}

TEST(MirroredStartState, TurnsWhatVisionShowedBefore) {
  StartState state;
  state.seen_before.resize(2);
  state.seen_before[1].time_s = -0.5;
  state.seen_before[1].robots[Side::kWest] = {RobotObservation{4, {1, 2}, {0, 1}}};
  state.seen_before[1].ball = BallObservation{{0.5, -1}, 0.1, {}};
  const Frame frame = mirrored(state).seen_before.at(1);
  EXPECT_EQ(frame.time_s, -0.5);
  EXPECT_TRUE(frame.robots[Side::kWest].empty());
  ASSERT_EQ(frame.robots[Side::kEast].size(), 1U);
  EXPECT_EQ(frame.robots[Side::kEast][0].position_m, Vec2(-1, -2));
  EXPECT_EQ(frame.ball->position_m, Vec2(-0.5, 1));
}

TEST(MirroredStartState, HasTheGhostOnTheOtherSide) {
  StartState state;
  EXPECT_FALSE(mirrored(state).ghost);
  state.ghost = Ghost{Side::kWest, {GhostFrame{0, {{.position_m = {1, 2}}}, std::nullopt}}, {3.0}};
  const StartState other = mirrored(state);
  EXPECT_EQ(other.ghost->side, Side::kEast);
  EXPECT_EQ(other.ghost->frames.at(0).robots.at(0).position_m, Vec2(-1, -2));
}

// A team that keeps its first view of the game.
class FirstViewTeam final : public strategies::Strategy {
 public:
  explicit FirstViewTeam(std::optional<TeamView>& first) : first_(&first) {}
  void decide(const TeamView& view, TeamCommands& /*commands*/) override {
    if (!*first_) *first_ = view;
  }

 private:
  std::optional<TeamView>* first_;
};

// The robot drives east with 1 m/s.
TEST(Game, ShowsTeamsFirstWhatWasSeenBeforeTheStart) {
  GameConfiguration game = rolling_ball();
  game.sim.latency_s = 0.1;  // six frames
  const Vec2 start_m = game.start->robots[Side::kWest][0].position_m;
  for (int number = -36; number < 0; ++number) {
    Frame frame;
    frame.number = number;
    frame.time_s = number / 60.0;
    frame.robots[Side::kWest] = {{2, start_m + Vec2(frame.time_s, 0), {1, 0}}};
    frame.ball = BallObservation{{2, 0.1}, 0};
    game.start->seen_before.push_back(frame);
  }
  std::optional<TeamView> first;
  Game played(
      game, nullptr,
      [&first](const TeamConfiguration& /*team*/, const strategies::TeamContext& /*context*/) {
        return std::make_unique<FirstViewTeam>(first);
      });
  played.step();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->frame, 0);
  ASSERT_EQ(first->own.size(), 1U);
  EXPECT_NEAR((first->own[0].position_m - (start_m - Vec2(0.1, 0))).norm(), 0, 1e-3);
  EXPECT_NEAR((first->own[0].velocity_mps - Vec2(1, 0)).norm(), 0, 0.02);
}

TEST(Game, RefusesAStartStateWithARobotThatItsTeamLacks) {
  GameConfiguration game = rolling_ball();
  game.start->robots[Side::kWest][0].number = 6;
  EXPECT_THROW(Game{game}, std::invalid_argument);
}

}  // namespace
}  // namespace autoref::game
