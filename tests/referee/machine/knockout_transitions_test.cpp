// One test suite per transition of games that must have a winner (Laws 2014, appendix A).
#include <gtest/gtest.h>

#include <string_view>

#include "referee/machine/penalty_outcome.hpp"
#include "soccer/team_view.hpp"
#include "tests/referee/rules/goals_only.hpp"

namespace autoref::referee {
namespace {

Configuration knockout(std::string_view book = "2014") {
  Configuration configuration = of_goals_only(book, 5);
  configuration.rules.extra_half_s = 4;
  configuration.knockout = true;
  return configuration;
}

ScriptedGame drawn_after_two_halves(const Configuration& configuration = knockout()) {
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.run_until("extra_time");
  return game;
}

TEST(TransitionExtraTime, FollowsADrawOfTwoHalves) {
  Configuration configuration = knockout();
  configuration.break_s = 3;
  ScriptedGame game = drawn_after_two_halves(configuration);
  EXPECT_EQ(game.count("half_over"), 1);
  EXPECT_EQ(game.signal.stage, Stage::kExtraTimeBreak);
  const double over_s = game.now_s();
  EXPECT_NEAR(game.run_until("next_half").time_s, over_s + 3, 1e-6);
  EXPECT_EQ(game.signal.stage, Stage::kExtraFirstHalfPre);
  EXPECT_EQ(game.run_until("prepare").command,
            (Command{CommandKind::kPrepareKickoff, Side::kWest}));
}

TEST(TransitionExtraTime, HasTwoHalvesWithTheirOwnLength) {
  ScriptedGame game = drawn_after_two_halves();
  const double first_s = game.run_until("start").time_s;
  EXPECT_EQ(game.signal.stage, Stage::kExtraFirstHalf);
  EXPECT_NEAR(game.run_until("half_over").time_s, first_s + 4, 1e-6);
  const double second_s = game.run_until("start").time_s;
  EXPECT_EQ(game.signal.stage, Stage::kExtraSecondHalf);
  EXPECT_NEAR(game.run_until("shootout").time_s, second_s + 4, 1e-6);
}

TEST(TransitionExtraTime, ChangesEndsBeforeEachHalfButNotForTheShootout) {
  ScriptedGame game = drawn_after_two_halves();
  EXPECT_FALSE(game.signal.blue_on_positive_half);
  game.run_until("half_over");
  EXPECT_TRUE(game.signal.blue_on_positive_half);
  game.run_until("shootout");
  EXPECT_FALSE(game.signal.blue_on_positive_half);
  game.run_until("shootout_begins");
  EXPECT_FALSE(game.signal.blue_on_positive_half);
}

TEST(TransitionExtraTime, DoesNotFollowAWin) {
  ScriptedGame game(knockout());
  game.line_up().kick_off();
  score(game, Side::kEast);
  game.run_until("game_over");
  EXPECT_EQ(game.count("extra_time"), 0);
}

TEST(TransitionExtraTime, FollowsASingleHalf) {
  Configuration configuration = knockout();
  configuration.halves = 1;
  ScriptedGame game = drawn_after_two_halves(configuration);
  game.run_until("start");
  EXPECT_EQ(game.signal.stage, Stage::kExtraFirstHalf);
}

TEST(TransitionExtraTime, HasItsOwnTimeouts) {
  Configuration configuration = knockout();
  configuration.rules.extra_timeouts_s = 7;
  ScriptedGame game = drawn_after_two_halves(configuration);
  game.requests[Side::kWest].timeout = true;
  const double began_s = game.run_until("timeout").time_s;
  EXPECT_NEAR(game.run_until("timeout_over").time_s, began_s + 7, 1e-6);
}

ScriptedGame drawn_after_extra_time(const Configuration& configuration = knockout()) {
  ScriptedGame game = drawn_after_two_halves(configuration);
  game.run_until("shootout");
  return game;
}

TEST(TransitionShootout, FollowsADrawOfExtraTime) {
  const ScriptedGame game = drawn_after_extra_time();
  EXPECT_EQ(game.signal.stage, Stage::kShootoutBreak);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kHalt);
}

TEST(TransitionShootout, DoesNotFollowAGoalInExtraTime) {
  ScriptedGame game = drawn_after_two_halves();
  game.run_until("start");
  score(game, Side::kWest);
  game.run_until("game_over");
  EXPECT_EQ(game.count("shootout"), 0);
}

// The side that kicked off the game begins, 750 mm from the target goal line (Laws 2014, single
// size).
TEST(TransitionShootoutBegins, PreparesTheFirstKickAtTheMark) {
  ScriptedGame game = drawn_after_extra_time();
  game.run_until("shootout_begins");
  EXPECT_EQ(game.signal.stage, Stage::kShootout);
  EXPECT_NEAR(game.signal.placement->target_m.x(), 3.025 - 0.75, 1e-9);
  EXPECT_EQ(game.run_until("prepare").command,
            (Command{CommandKind::kPreparePenalty, Side::kWest}));
  EXPECT_EQ(game.run_until("start").command, (Command{CommandKind::kNormalStart, Side::kWest}));
}

// The next kicker shoots into the empty goal, or beside it.
void shoot(ScriptedGame& game, bool scores) {
  game.run_until("start");
  const double direction = game.frame.ball->position_m.x() > 0 ? 1 : -1;
  const Side kicker = direction > 0 ? Side::kWest : Side::kEast;
  game.kick(kicker, 1, Vec2(direction * 5, scores ? 0 : 4));
  game.run_until(scores ? "shootout_goal" : "shootout_miss", 5);
}

ScriptedGame in_shootout(const Configuration& configuration = knockout()) {
  ScriptedGame game = drawn_after_extra_time(configuration);
  game.run_until("shootout_begins");
  return game;
}

TEST(TransitionShootoutGoal, IsNotAddedToTheScore) {
  ScriptedGame game = in_shootout();
  shoot(game, true);
  EXPECT_EQ(game.signal.command, (Command{CommandKind::kGoal, Side::kWest}));
  EXPECT_EQ(game.signal.shootout_goals, (PerSide<int>{{1, 0}}));
  EXPECT_EQ(game.signal.goals, (PerSide<int>{{0, 0}}));
  EXPECT_EQ(game.referee.shootout_goals(), (PerSide<int>{{1, 0}}));
}

TEST(TransitionShootoutGoal, IsFollowedByTheOtherSidesKick) {
  ScriptedGame game = in_shootout();
  shoot(game, true);
  EXPECT_EQ(game.run_until("prepare").command,
            (Command{CommandKind::kPreparePenalty, Side::kEast}));
  EXPECT_NEAR(game.signal.placement->target_m.x(), -(3.025 - 0.75), 1e-9);
}

TEST(TransitionShootoutMiss, FollowsABallThatGoesOut) {
  ScriptedGame game = in_shootout();
  shoot(game, false);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kStop);
  EXPECT_EQ(game.signal.shootout_goals, (PerSide<int>{{0, 0}}));
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kPreparePenalty, Side::kEast}));
}

// "The attacking robot has 10 seconds to score."
TEST(TransitionShootoutMiss, FollowsAKickThatTakesTooLong) {
  ScriptedGame game = in_shootout();
  const double began_s = game.run_until("start").time_s;
  EXPECT_NEAR(game.run_until("shootout_miss").time_s, began_s + 10, 1e-6);
}

TEST(TransitionShootoutMiss, FollowsABallThatTheKeeperTurnsBack) {
  ScriptedGame game = in_shootout();
  game.run_until("start");
  // The ball reaches the keeper's plate after seven frames.
  const double touched_x_m = game.frame.ball->position_m.x() + 7 * 4.0 / 60;
  const double keeper_x_m = touched_x_m + kBallRadius_m + kFrontDistance_m + 0.001;
  game.robot(Side::kEast, 0) = {0, Vec2(keeper_x_m, 0), Vec2(-1, 0)};
  game.kick(Side::kWest, 1, {4, 0});
  game.run(7 / ScriptedGame::kRate_hz);
  EXPECT_EQ(game.count("shootout_miss"), 0);
  game.ball_mps = Vec2(-2, 0);
  game.run_until("shootout_miss", 0.5);
}

// Each side takes that many kicks, beginning with the first.
void shoot_in_turn(ScriptedGame& game, int kicks, bool first_scores, bool second_scores) {
  for (int i = 0; i < kicks; ++i) {
    shoot(game, first_scores);
    shoot(game, second_scores);
  }
}

// The remaining kicks cannot change the winner: 3 to 0 after three of five kicks each.
TEST(TransitionShootoutOver, IsTakenAsSoonAsTheWinnerIsCertain) {
  ScriptedGame game = in_shootout();
  shoot_in_turn(game, 3, true, false);
  const Decision over = game.run_until("shootout_over", 1);
  EXPECT_EQ(over.to, State::kOver);
  EXPECT_EQ(game.signal.stage, Stage::kPostGame);
  EXPECT_EQ(game.referee.shootout_goals(), (PerSide<int>{{3, 0}}));
}

TEST(TransitionShootoutOver, IsTakenAfterOneMoreEachIfFiveDoNotDecide) {
  ScriptedGame game = in_shootout();
  shoot_in_turn(game, 5, false, false);
  shoot(game, true);
  game.run(0.5);
  EXPECT_FALSE(game.referee.is_over());  // the other side still has its sixth kick
  shoot(game, false);
  game.run_until("shootout_over", 1);
}

TEST(TransitionShootoutOverNext, LeadsToTheNextGame) {
  Configuration configuration = knockout();
  configuration.after_game = AfterGame::kNewGame;
  ScriptedGame game = in_shootout(configuration);
  shoot_in_turn(game, 3, false, true);
  EXPECT_EQ(game.run_until("shootout_over_next").to, State::kDelayWait);
  game.run_until("new_game", 0.1);
  EXPECT_FALSE(game.referee.shootout_goals().has_value());
}

TEST(Shootout, IsADrawAfterFiftyGoallessKicksEach) {
  EXPECT_FALSE(is_over({{{50, 49}}, {{0, 0}}}, 5));
  EXPECT_TRUE(is_over({{{50, 50}}, {{0, 0}}}, 5));
  EXPECT_FALSE(is_decided({{{50, 50}}, {{0, 0}}}, 5));
}

TEST(Shootout, IsDecidedOnceTheOtherSideCannotDrawLevel) {
  EXPECT_FALSE(is_decided({{{3, 3}}, {{2, 0}}}, 5));
  EXPECT_TRUE(is_decided({{{4, 3}}, {{3, 0}}}, 5));
  EXPECT_TRUE(is_decided({{{4, 4}}, {{0, 2}}}, 5));
  EXPECT_FALSE(is_decided({{{5, 4}}, {{3, 3}}}, 5));
}

// Other robots keep away from a kick of the shoot-out until it is over.
TEST(Shootout, StaysAPenaltyKickForTheTeamsAfterTheBallHasMoved) {
  SituationTracker tracker{RuleBook{}};
  RefereeSignal signal;
  signal.stage = Stage::kShootout;
  signal.command = {CommandKind::kPreparePenalty, Side::kWest};
  signal.command_counter = 1;
  tracker.update(signal, Vec2(2, 0));
  signal.command = {CommandKind::kNormalStart, Side::kWest};
  signal.command_counter = 2;
  tracker.update(signal, Vec2(2, 0));
  EXPECT_EQ(tracker.update(signal, Vec2(2.5, 0)).play, Play::kPenalty);
}

}  // namespace
}  // namespace autoref::referee
