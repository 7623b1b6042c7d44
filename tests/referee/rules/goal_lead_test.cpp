// Early termination of games, and the clock that stops with play (2026).
#include <gtest/gtest.h>

#include "tests/referee/rules/goals_only.hpp"

namespace autoref::referee {
namespace {

// "When a team manages to shoot 10 goals, the match is automatically terminated as soon as the goal
// difference is greater than one" (2026).
TEST(TransitionGoalLead, EndsTheGameAtTenGoalsRightAfterTheTenth) {
  ScriptedGame game = in_play(of_goals_only("2026-b", 600));
  score_times(game, Side::kEast, 9);
  game.run_until("start");
  EXPECT_FALSE(game.referee.is_over());
  score(game, Side::kEast);
  const double scored_s = game.now_s();
  EXPECT_EQ(game.signal.command.kind, CommandKind::kGoal);
  EXPECT_NEAR(game.run_until("goal_lead").time_s, scored_s + 1.0 / 60, 1e-6);
  EXPECT_TRUE(game.referee.is_over());
  EXPECT_EQ(game.signal.command.kind, CommandKind::kHalt);
}

TEST(TransitionGoalLead, NeedsALeadOfTwo) {
  ScriptedGame game = in_play(of_goals_only("2026-b", 600));
  score_times(game, Side::kEast, 9);
  game.run_until("start");
  score_times(game, Side::kWest, 9);
  game.run_until("start");
  score(game, Side::kWest);
  game.run_until("start");
  score(game, Side::kWest);
  game.run_until("goal_lead");
  EXPECT_EQ(game.signal.goals, (PerSide<int>{{9, 11}}));
}

TEST(TransitionGoalLeadNext, LeadsToTheNextGame) {
  Configuration configuration = of_goals_only("2026-b", 600);
  configuration.after_game = AfterGame::kNewGame;
  ScriptedGame game = in_play(configuration);
  score_times(game, Side::kEast, 10);
  EXPECT_EQ(game.run_until("goal_lead_next").to, State::kDelayWait);
  EXPECT_EQ(game.signal.command.kind, CommandKind::kHalt);
  game.run_until("new_game", 0.1);
  EXPECT_EQ(game.referee.games_finished(), 1);
}

// "The match timer is paused whenever no team is allowed to manipulate the ball" (2026).
TEST(ClockStops, WhilePlayIsStopped) {
  ScriptedGame game = in_play(of_goals_only("2026-b", 600));
  const double before_s = game.signal.stage_time_left_s;
  game.run(2);
  EXPECT_NEAR(game.signal.stage_time_left_s, before_s - 2, 1e-6);
  score(game, Side::kEast);
  const double left_s = game.signal.stage_time_left_s;
  game.run_until("start");
  EXPECT_NEAR(game.signal.stage_time_left_s, left_s, 1e-6);
}

TEST(ClockStops, DoesNotStopUnderTheLawsOf2014) {
  ScriptedGame game = in_play(of_goals_only("2014", 600));
  score(game, Side::kEast);
  const double left_s = game.signal.stage_time_left_s;
  const double scored_s = game.now_s();
  game.run_until("start");
  EXPECT_NEAR(game.signal.stage_time_left_s, left_s - (game.now_s() - scored_s), 1e-6);
}

}  // namespace
}  // namespace autoref::referee
