// One test suite per transition, named after it, for every row of the transition table. This file
// covers the figure; half_transitions_test.cpp covers the ends of halves and games.
#include <gtest/gtest.h>

#include <cctype>
#include <set>
#include <string>

#include "referee/machine/machine.hpp"
#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

constexpr Command kStop{CommandKind::kStop, Side::kWest};
constexpr Command kForceStart{CommandKind::kForceStart, Side::kWest};
constexpr Command kNormalStart{CommandKind::kNormalStart, Side::kWest};

std::string suite_of(std::string_view label) {
  std::string suite = "Transition";
  bool upper = true;
  for (const char c : label) {
    if (c != '_') suite += upper ? static_cast<char>(std::toupper(c)) : c;
    upper = c == '_';
  }
  return suite;
}

TEST(EveryTransition, HasASuiteNamedAfterIt) {
  std::set<std::string> suites;
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    suites.insert(all.GetTestSuite(i)->name());
  }
  for (const auto& transitions : {transitions_in_figure(), transitions_outside_figure()}) {
    for (const Transition& transition : transitions) {
      EXPECT_TRUE(suites.contains(suite_of(transition.label))) << suite_of(transition.label);
    }
  }
}

TEST(TransitionBegin, SendsStopAndEntersWaitStartAfterOneFrame) {
  ScriptedGame game;
  EXPECT_EQ(game.referee.state(), State::kInit);
  game.line_up().step();
  EXPECT_EQ(game.referee.state(), State::kWaitStart);
  EXPECT_EQ(game.signal.command, kStop);
  EXPECT_EQ(game.signal.stage, Stage::kFirstHalfPre);
}

TEST(TransitionClientsMoved, PreparesTheKickOffOnceARobotOfEachTeamHasMoved) {
  ScriptedGame game;
  game.line_up().step();
  game.robot(Side::kWest, 3).position_m.x() += 0.016;
  game.robot(Side::kEast, 1).position_m.x() += 0.016;
  const Decision moved = game.run_until("clients_moved", 2);
  EXPECT_EQ(moved.to, State::kWaitStop);
  EXPECT_EQ(moved.command, (Command{CommandKind::kPrepareKickoff, Side::kWest}));
  EXPECT_EQ(game.signal.placement->target_m, Vec2(0, 0));
  EXPECT_EQ(game.signal.next_command, kNormalStart);
}

TEST(TransitionClientsMoved, IsNotTakenWhileOneTeamStandsStill) {
  ScriptedGame game;
  game.line_up().step();
  game.robot(Side::kWest, 3).position_m.x() += 0.5;
  game.robot(Side::kEast, 1).position_m.x() += 0.014;
  game.run(9);
  EXPECT_EQ(game.referee.state(), State::kWaitStart);
}

TEST(TransitionStartTimeout, IsTakenAfterTenSecondsWithoutMotion) {
  Configuration configuration;
  configuration.first_kickoff = Side::kEast;
  ScriptedGame game(configuration);
  const Decision late = game.line_up().run_until("start_timeout");
  EXPECT_NEAR(late.time_s, 10, 1e-9);
  EXPECT_EQ(late.command, (Command{CommandKind::kPrepareKickoff, Side::kEast}));
}

TEST(TransitionPrepare, SendsThePreparationAndWaitsAgain) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  const Decision prepared = game.run_until("prepare");
  EXPECT_EQ(prepared.to, State::kWaitStop);
  EXPECT_EQ(prepared.command, (Command{CommandKind::kPrepareKickoff, Side::kEast}));
  const double prepared_s = prepared.time_s;
  EXPECT_NEAR(game.run_until("start").time_s, prepared_s + 1, 1e-9);
}

TEST(TransitionPrepareLate, SendsThePreparationAfterTheTimeout) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  const double stopped_s = game.run_until("signalled").time_s;
  for (int i = 0; i < 16 * 60 && game.count("prepare_late") == 0; ++i) {
    game.robot(Side::kEast, 4).position_m.y() += i % 120 < 60 ? 0.001 : -0.001;
    game.step();
  }
  ASSERT_EQ(game.count("prepare_late"), 1);
  EXPECT_NEAR(game.decisions.back().time_s, stopped_s + 15, 1e-9);
}

TEST(TransitionStart, SendsTheNextCommandAndEntersRun) {
  ScriptedGame game;
  game.line_up().kick_off();
  EXPECT_EQ(game.referee.state(), State::kRun);
  EXPECT_EQ(game.signal.command, kNormalStart);
  EXPECT_FALSE(game.signal.placement.has_value());
  EXPECT_FALSE(game.signal.next_command.has_value());
}

TEST(TransitionStartLate, EntersRunAfterTheTimeoutWithTheBallSetToItsPosition) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  game.placement_works = false;  // the ball is not moved there
  game.run_until("throw_in");
  bool was_set_at_once = false;
  while (game.count("start_late") == 0 && game.now_s() < 60) {
    game.robot(Side::kEast, 2).position_m.y() += 0.001;  // never comes to rest
    game.step();
    const bool at_once = game.signal.placement && game.signal.placement->at_once;
    if (at_once) game.put_ball(game.signal.placement->target_m);
    was_set_at_once = was_set_at_once || at_once;
  }
  EXPECT_TRUE(was_set_at_once);
  EXPECT_EQ(game.signal.command, (Command{CommandKind::kIndirectFree, Side::kEast}));
  EXPECT_NEAR((game.frame.ball->position_m - Vec2(1, 1.925)).norm(), 0, 1e-9);
}

TEST(TransitionGoal, ScoresAndSendsGoalForOneFrame) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  const Decision goal = game.run_until("goal");
  EXPECT_EQ(goal.to, State::kDelayWait);
  EXPECT_EQ(goal.command, (Command{CommandKind::kGoal, Side::kWest}));
  EXPECT_EQ(game.signal.goals[Side::kWest], 1);
  EXPECT_EQ(game.signal.placement->target_m, Vec2(0, 0));
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kPrepareKickoff, Side::kEast}));
}

TEST(TransitionThrowIn, GivesTheBallToTheOpponents) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kEast, 1, {-1, -1.8}, {0, -4});
  const Decision out = game.run_until("throw_in");
  EXPECT_EQ(out.to, State::kWaitStop);
  EXPECT_EQ(out.command, kStop);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kIndirectFree, Side::kWest}));
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(-1, -1.925)).norm(), 0, 1e-9);
}

TEST(TransitionCornerKick, IsTakenWhenADefenderTouchedTheBallLast) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {-2.8, 1.0}, {-4, 0});
  game.run_until("corner_kick");
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(-2.925, 1.925)).norm(), 0, 1e-9);
}

TEST(TransitionGoalKick, IsTakenWhenAnAttackerTouchedTheBallLast) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kEast, 1, {-2.8, 1.0}, {-4, 0});
  game.run_until("goal_kick");
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kWest}));
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(-2.525, 1.925)).norm(), 0, 1e-9);
}

TEST(TransitionTouchLineUnknown, LeadsToAForceStartFrom100MillimetresInside) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({0.5, 1.5});
  game.ball_mps = {0, 4};
  const Decision out = game.run_until("touch_line_unknown");
  EXPECT_FALSE(out.last_touch.side.has_value());
  EXPECT_EQ(game.signal.next_command, kForceStart);
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(0.5, 1.925)).norm(), 0, 1e-9);
}

TEST(TransitionAttackerTooCloseToDefenseArea, GivesAnIndirectFreeKickToTheDefenders) {
  ScriptedGame game;
  game.line_up().kick_off();
  // The area's edge is 0.8 m from the goal line; the robot's round back, 90 mm, faces it.
  game.robot(Side::kWest, 2) = {2, {3.025 - 0.8 - 0.19 - 0.09, 0}, Vec2(-1, 0)};
  game.kick(Side::kWest, 1, {-3, 0});
  const Decision call = game.run_until("attacker_too_close_to_defense_area", 1);
  EXPECT_NEAR(call.finding.value, 0.190, 1e-9);
  ASSERT_EQ(call.finding.robots.size(), 1U);
  EXPECT_EQ(call.finding.robots[0], (RobotId{Side::kWest, 2}));
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kIndirectFree, Side::kEast}));
}

TEST(TransitionSignalled, SendsStopOneFrameAfterTheGoal) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  const double goal_s = game.run_until("goal").time_s;
  game.step();
  EXPECT_EQ(game.decisions.back().transition, "signalled");
  EXPECT_NEAR(game.decisions.back().time_s, goal_s + 1.0 / 60, 1e-9);
  EXPECT_EQ(game.signal.command, kStop);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kPrepareKickoff, Side::kEast}));
}

TEST(TransitionRestartNotTaken, LeadsToAForceStartAfterTenSeconds) {
  ScriptedGame game;
  game.line_up().kick_off();
  const double started_s = game.now_s();
  const Decision late = game.run_until("restart_not_taken");
  EXPECT_NEAR(late.time_s, started_s + 10, 1e-9);
  EXPECT_EQ(game.signal.next_command, kForceStart);
  game.run_until("start");
  EXPECT_EQ(game.signal.command, kForceStart);
  EXPECT_TRUE(game.referee.is_ball_in_play());
}

TEST(TransitionStuckBall, LeadsToAForceStartFromANeutralPosition) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.put_ball({2.6, 0.5});
  game.step();
  const double stuck_s = game.now_s();
  const Decision stuck = game.run_until("stuck_ball");
  EXPECT_NEAR(stuck.time_s, stuck_s + 10, 1e-9);
  EXPECT_EQ(game.signal.next_command, kForceStart);
  const Vec2 position_m = game.signal.placement->target_m;
  EXPECT_GE(distance_to_defence_area(Field{}, Side::kEast, position_m), 0.7 - 1e-9);
}

}  // namespace
}  // namespace autoref::referee
