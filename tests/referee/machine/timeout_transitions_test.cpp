// One test suite per transition of timeouts (Laws 2014, law 7: four with 300 s in total; 2026).
#include <gtest/gtest.h>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

Configuration with_timeouts(std::string_view book) {
  Configuration configuration;
  configuration.rules = *find_rule_book(book);
  // Position rules are off, because the scripted robots do not follow them.
  configuration.rules.in_force = {RuleId::kGoal, RuleId::kBallLeavesField, RuleId::kTimeouts};
  configuration.robots = {{6, 6}};
  configuration.half_s = 600;
  return configuration;
}

// A throw-in for east has just been awarded.
ScriptedGame stopped_for_throw_in(const Configuration& configuration = with_timeouts("2014")) {
  ScriptedGame game = in_play(configuration);
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  game.run_until("throw_in");
  return game;
}

TEST(TransitionTimeout, IsTakenOnRequestWhilePlayIsStopped) {
  ScriptedGame game = stopped_for_throw_in();
  game.requests[Side::kWest].timeout = true;
  const Decision timeout = game.run_until("timeout", 0.1);
  EXPECT_EQ(timeout.from, State::kWaitStop);
  EXPECT_EQ(timeout.to, State::kTimeout);
  EXPECT_EQ(timeout.command, (Command{CommandKind::kTimeout, Side::kWest}));
}

TEST(TransitionTimeout, LeavesLessInTheSignal) {
  ScriptedGame game = stopped_for_throw_in();
  EXPECT_EQ(game.signal.timeouts_left, (PerSide<int>{{4, 4}}));
  EXPECT_EQ(game.signal.timeout_left_s, (PerSide<double>{{300, 300}}));
  game.requests[Side::kWest].timeout = true;
  game.run_until("timeout", 0.1);
  game.run(10);
  EXPECT_EQ(game.signal.timeouts_left, (PerSide<int>{{3, 4}}));
  EXPECT_NEAR(game.signal.timeout_left_s[Side::kWest], 290, 0.05);
  game.requests[Side::kWest].timeout = false;
  game.run(10);
  EXPECT_NEAR(game.signal.timeout_left_s[Side::kWest], 290, 0.1);
  EXPECT_EQ(game.signal.timeout_left_s[Side::kEast], 300);
}

TEST(TransitionTimeout, WaitsForAStop) {
  ScriptedGame game = in_play(with_timeouts("2014"));
  game.requests[Side::kWest].timeout = true;
  game.run(5);
  EXPECT_EQ(game.referee.state(), State::kRun);
}

// "At the beginning of the match": the match has not begun before the first kick-off.
TEST(TransitionTimeout, IsNotTakenBeforeTheFirstKickOff) {
  ScriptedGame game(with_timeouts("2014"));
  game.requests[Side::kEast].timeout = true;
  game.line_up().kick_off();
  EXPECT_EQ(game.count("timeout"), 0);
}

TEST(TransitionTimeout, IsGrantedFirstToTheSideThatTakesTheRestart) {
  ScriptedGame game = stopped_for_throw_in();
  game.requests[Side::kWest].timeout = game.requests[Side::kEast].timeout = true;
  const Decision first = game.run_until("timeout", 0.1);
  EXPECT_EQ(first.command, (Command{CommandKind::kTimeout, Side::kEast}));
  game.requests[Side::kEast].timeout = false;
  const Decision second = game.run_until("timeout", 0.1);
  EXPECT_EQ(second.command, (Command{CommandKind::kTimeout, Side::kWest}));
}

// After 10 s without a kick there is a force start, which belongs to neither side.
ScriptedGame before_force_start() {
  Configuration configuration = with_timeouts("2014");
  configuration.rules.in_force[RuleId::kRestartNotTaken] = true;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.run_until("restart_not_taken");
  return game;
}

TEST(TransitionTimeout, BeforeAForceStartIsGrantedFirstToTheSideThatHasUsedLess) {
  ScriptedGame game = before_force_start();
  game.requests[Side::kEast].timeout = true;
  game.run(1);
  game.requests[Side::kEast].timeout = false;
  game.run_until("timeout_over");
  game.requests[Side::kWest].timeout = game.requests[Side::kEast].timeout = true;
  EXPECT_EQ(game.run_until("timeout", 0.1).command, (Command{CommandKind::kTimeout, Side::kWest}));
}

TEST(TransitionTimeout, BeforeAForceStartIsGrantedFirstToTheSideThatDidNotKickOff) {
  ScriptedGame game = before_force_start();
  game.requests[Side::kWest].timeout = game.requests[Side::kEast].timeout = true;
  EXPECT_EQ(game.run_until("timeout", 0.1).command, (Command{CommandKind::kTimeout, Side::kEast}));
}

// West requests that many timeouts, one after the other.
void request_timeouts(ScriptedGame& game, int count) {
  for (int i = 0; i < count; ++i) {
    game.requests[Side::kWest].timeout = true;
    game.run(0.1);
    game.requests[Side::kWest].timeout = false;
    game.run(0.1);
  }
}

TEST(TransitionTimeout, IsTakenFourTimesByATeam) {
  ScriptedGame game = stopped_for_throw_in();
  request_timeouts(game, 6);
  EXPECT_EQ(game.count("timeout"), 4);
}

// Double size in 2014 allows six timeouts with 450 s in total; 2026 allows as many as single size.
// How long a timeout lasts that nobody ends; nobody gets another one.
double timeout_by_s(const char* book) {
  ScriptedGame game = stopped_for_throw_in(with_timeouts(book));
  game.requests[Side::kWest].timeout = true;
  const double began_s = game.run_until("timeout").time_s;
  const double ended_s = game.run_until("timeout_over", 500).time_s;
  game.run(5);
  EXPECT_EQ(game.count("timeout"), 1) << book;
  return ended_s - began_s;
}

TEST(TransitionTimeout, LastsAsLongAsTheBookAllows) {
  EXPECT_NEAR(timeout_by_s("2014"), 300, 1e-6);
  EXPECT_NEAR(timeout_by_s("2014-double"), 450, 1e-6);
  EXPECT_NEAR(timeout_by_s("2026-b"), 300, 1e-6);
}

TEST(TransitionTimeoutOver, ContinuesWithTheSameRestart) {
  ScriptedGame game = stopped_for_throw_in();
  const Vec2 position_m = game.signal.placement->target_m;
  game.requests[Side::kWest].timeout = true;
  game.run(20);
  game.requests[Side::kWest].timeout = false;
  const Decision over = game.run_until("timeout_over", 0.1);
  EXPECT_EQ(over.to, State::kWaitStop);
  EXPECT_EQ(over.command, (Command{CommandKind::kStop, Side::kWest}));
  EXPECT_EQ(game.signal.placement->target_m, position_m);
  // The wait starts again and lasts one check period.
  const Decision start = game.run_until("start");
  EXPECT_NEAR(start.time_s, over.time_s + 1, 1e-6);
  EXPECT_EQ(start.command, (Command{CommandKind::kIndirectFree, Side::kEast}));
}

TEST(TransitionTimeoutOver, PreparesAKickOffAgain) {
  ScriptedGame game = in_play(with_timeouts("2014"));
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  game.run_until("prepare");
  game.requests[Side::kEast].timeout = true;
  game.run(1);
  game.requests[Side::kEast].timeout = false;
  game.run_until("timeout_over", 0.1);
  EXPECT_EQ(game.run_until("prepare").command,
            (Command{CommandKind::kPrepareKickoff, Side::kEast}));
  EXPECT_EQ(game.run_until("start").command, (Command{CommandKind::kNormalStart, Side::kWest}));
}

TEST(TransitionTimeoutOver, ContinuesTheClock) {
  ScriptedGame game = stopped_for_throw_in();
  game.requests[Side::kWest].timeout = true;
  game.run_until("timeout", 0.1);
  const double left_s = game.signal.stage_time_left_s;
  game.run(60);
  EXPECT_NEAR(game.signal.stage_time_left_s, left_s, 1e-6);
  game.requests[Side::kWest].timeout = false;
  game.run(0.5);
  EXPECT_NEAR(game.signal.stage_time_left_s, left_s - 0.5, 0.05);
}

}  // namespace
}  // namespace autoref::referee
