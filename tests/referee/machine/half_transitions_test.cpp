// One test suite per transition that the paper's figure leaves out: the ends of halves and games.
#include <gtest/gtest.h>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

Configuration short_game() {
  Configuration configuration;
  configuration.half_s = 5;
  return configuration;
}

TEST(TransitionHalfOver, SendsHaltAtHalfTime) {
  ScriptedGame game(short_game());
  game.line_up().kick_off();
  const double began_s = game.now_s();
  const Decision over = game.run_until("half_over");
  EXPECT_NEAR(over.time_s, began_s + 5, 1e-9);
  EXPECT_EQ(over.to, State::kDelayWait);
  EXPECT_EQ(over.command, (Command{CommandKind::kHalt, Side::kWest}));
  EXPECT_EQ(game.signal.stage, Stage::kHalfTime);
}

TEST(TransitionNextHalf, WaitsForTheBreakThenPreparesTheOtherTeamsKickOff) {
  Configuration configuration = short_game();
  configuration.break_s = 3;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  const double over_s = game.run_until("half_over").time_s;
  EXPECT_NEAR(game.run_until("next_half").time_s, over_s + 3, 1e-9);
  EXPECT_EQ(game.signal.stage, Stage::kSecondHalfPre);
  game.run_until("prepare");
  EXPECT_EQ(game.signal.command, (Command{CommandKind::kPrepareKickoff, Side::kEast}));
  game.run_until("start");
  EXPECT_EQ(game.signal.stage, Stage::kSecondHalf);
}

class TransitionNextHalfWhere : public testing::TestWithParam<bool> {};  // teams change ends

TEST_P(TransitionNextHalfWhere, ChangesEndsAfterTheBreakIfTheRuleBookSaysSo) {
  Configuration configuration = short_game();
  configuration.rules.change_ends = GetParam();
  configuration.break_s = 3;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  EXPECT_TRUE(game.run_until("half_over").blue_on_positive_half);
  game.run(2.9);
  EXPECT_TRUE(game.signal.blue_on_positive_half);
  EXPECT_EQ(game.run_until("next_half").blue_on_positive_half, !GetParam());
  EXPECT_EQ(game.signal.blue_on_positive_half, !GetParam());
}

INSTANTIATE_TEST_SUITE_P(Teams, TransitionNextHalfWhere, testing::Bool(), [](const auto& test) {
  return test.param ? "ChangeEnds" : "KeepTheirEnds";
});

TEST(TransitionGameOver, HaltsPermanentlyAfterTheLastHalf) {
  ScriptedGame game(short_game());
  game.line_up().kick_off();
  game.run_until("game_over");
  EXPECT_TRUE(game.referee.is_over());
  EXPECT_EQ(game.signal.command.kind, CommandKind::kHalt);
  EXPECT_EQ(game.signal.stage, Stage::kPostGame);
  const std::size_t decisions = game.decisions.size();
  game.run(30);
  EXPECT_EQ(game.decisions.size(), decisions);
}

Configuration endless() {
  Configuration configuration = short_game();
  configuration.halves = 1;
  configuration.after_game = AfterGame::kNewGame;
  return configuration;
}

TEST(TransitionGameOverNext, CountsTheGame) {
  ScriptedGame game(endless());
  game.line_up().kick_off();
  EXPECT_EQ(game.run_until("game_over_next").to, State::kDelayWait);
  EXPECT_EQ(game.referee.games_finished(), 1);
  EXPECT_FALSE(game.referee.is_over());
}

TEST(TransitionNewGame, BeginsAtTheFirstEnds) {
  Configuration configuration = endless();
  configuration.halves = 2;
  configuration.rules.change_ends = true;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.run_until("game_over_next");
  EXPECT_FALSE(game.signal.blue_on_positive_half);
  game.run_until("new_game");
  EXPECT_TRUE(game.signal.blue_on_positive_half);
}

TEST(TransitionNewGame, BeginsWithScoresAtZero) {
  ScriptedGame game(endless());
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  game.run_until("game_over_next");
  EXPECT_EQ(game.signal.goals[Side::kWest], 1);
  game.run_until("new_game");
  EXPECT_EQ(game.signal.goals[Side::kWest], 0);
  EXPECT_EQ(game.referee.goals_by_half().size(), 1U);
  EXPECT_EQ(game.signal.stage, Stage::kFirstHalfPre);
  game.run_until("prepare");
  EXPECT_EQ(game.signal.command, (Command{CommandKind::kPrepareKickoff, Side::kWest}));
}

}  // namespace
}  // namespace autoref::referee
