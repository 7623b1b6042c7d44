// One test per sentence of the paper's section 4.2 that states a rule; suites are named after the
// section and paragraph.
#include <gtest/gtest.h>

#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

constexpr Command kIndirectFreeEast{CommandKind::kIndirectFree, Side::kEast};

// "Each half of the game lasts ten minutes"
TEST(Paper42TimeRules, HalvesLastTenMinutesByDefault) { EXPECT_EQ(Configuration{}.half_s, 600); }

// "AutoRef keeps track of the elapsed time in the game and ends the current half when appropriate"
TEST(Paper42TimeRules, TheHalfEndsWhenItsTimeIsOver) {
  Configuration configuration;
  configuration.half_s = 20;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  const double began_s = game.now_s();
  EXPECT_NEAR(game.signal.stage_time_left_s, 20, 1e-9);
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  game.placement_works = false;  // play does not resume before the end
  EXPECT_NEAR(game.run_until("half_over").time_s, began_s + 20, 1e-9);
}

// "Time starts counting when the ready command is sent to teams at the beginning of a half"
TEST(Paper42TimeRules, TheClockStartsWithNormalStart) {
  ScriptedGame game;
  game.line_up();
  game.run(3);
  EXPECT_EQ(game.signal.stage, Stage::kFirstHalfPre);
  EXPECT_EQ(game.signal.stage_time_left_s, 0);
  game.run_until("start");
  EXPECT_EQ(game.signal.stage, Stage::kFirstHalf);
  EXPECT_EQ(game.signal.stage_time_left_s, 600);
}

// "... when the ready command is sent": later ready commands do not restart it.
TEST(Paper42TimeRules, TheClockRunsOnThroughStops) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {2.5, 0}, {6, 0});
  game.run_until("goal");
  const double left_s = game.signal.stage_time_left_s;
  game.run_until("start");  // two checks later: one before the preparation, one after
  EXPECT_LT(game.signal.stage_time_left_s, left_s - 2);
}

// "At the end of the second half, AutoRef can either signal for a new game to begin or simply leave
// the robots halted"
TEST(Paper42TimeRules, TheSecondHalfEndsWithHalt) {
  Configuration configuration;
  configuration.half_s = 2;
  ScriptedGame game(configuration);
  game.line_up().kick_off();
  game.run_until("half_over");
  game.run_until("game_over");
  EXPECT_EQ(game.signal.command.kind, CommandKind::kHalt);
  EXPECT_EQ(game.referee.goals_by_half().size(), 2U);
}

// "When the ball enters one of the goals, a goal is awarded to the appropriate team"
TEST(Paper42BallRules, AGoalCountsForTheTeamThatShootsAtIt) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kEast, 1, {-2.5, 0}, {-6, 0});
  game.run_until("goal");
  EXPECT_EQ(game.signal.goals[Side::kEast], 1);
  EXPECT_EQ(game.signal.goals[Side::kWest], 0);
  EXPECT_EQ(game.referee.goals_by_half()[0][Side::kEast], 1);
}

TEST(Paper42BallRules, AnOwnGoalCountsForTheOpponents) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {-2.5, 0}, {-6, 0});
  game.run_until("goal");
  EXPECT_EQ(game.signal.goals[Side::kEast], 1);
}

// "... the ball is placed in the center of the field, and a kickoff is signaled"
TEST(Paper42BallRules, AfterAGoalTheOpponentsKickOffFromTheCentre) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kEast, 1, {-2.5, 0}, {-6, 0});
  game.run_until("goal");
  EXPECT_EQ(game.signal.placement->target_m, Vec2(0, 0));
  game.run_until("prepare");
  EXPECT_EQ(game.signal.command, (Command{CommandKind::kPrepareKickoff, Side::kWest}));
}

// "When the ball leaves the field without entering a goal, a free kick is awarded to the team which
// touched the ball less recently"
TEST(Paper42BallRules, TheFreeKickIsForTheTeamThatTouchedTheBallLessRecently) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kEast, 1, {1, 1.0}, {0, -1});
  game.run(0.3);
  game.kick(Side::kWest, 1, {0, 4});
  game.run_until("throw_in");
  EXPECT_EQ(game.signal.next_command, kIndirectFreeEast);
}

// "If the ball passes over a touch line, a throw-in is awarded"
// "throw-ins are taken from a point 100 mm from the point where the ball exited the field"
TEST(Paper42BallRules, AThrowInIsTaken100MillimetresFromTheExit) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {-0.7, 1.8}, {0, 4});
  game.run_until("throw_in");
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(-0.7, 1.925)).norm(), 0, 1e-9);
}

// "If the ball passes over a goal line, a corner kick is awarded if the defending team touched
// the ball more recently"; "100 mm from the nearest touch line and 100 mm ... from the goal
// boundary that was crossed"
TEST(Paper42BallRules, ACornerKickIsTaken100MillimetresFromBothLines) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kEast, 1, {2.8, -1.0}, {4, 0});
  game.run_until("corner_kick");
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kWest}));
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(2.925, -1.925)).norm(), 0, 1e-9);
}

// "... or a goal kick otherwise"; "100 mm ... and ... 500 mm"
TEST(Paper42BallRules, AGoalKickIsTaken500MillimetresFromTheGoalLine) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {2.8, -1.0}, {4, 0});
  game.run_until("goal_kick");
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_NEAR((game.signal.placement->target_m - Vec2(2.525, -1.925)).norm(), 0, 1e-9);
}

TEST(Paper42BallRules, OtherwiseIncludesAnUnknownLastTouch) {
  ScriptedGame game = in_play();
  game.put_ball({2.8, -1.0});
  game.ball_mps = {4, 0};
  game.run_until("goal_kick");
  EXPECT_FALSE(game.decisions.back().last_touch.side.has_value());
}

// "it can also restart gameplay at an appropriate time (once all robots have stopped moving, with a
// fixed timeout to avoid waiting forever)"
TEST(Paper42BallRules, PlayWaitsWhileARobotMoves) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  const double stopped_s = game.run_until("throw_in").time_s;
  for (int i = 0; i < 300; ++i) {
    game.robot(Side::kEast, 4).position_m.y() -= 0.0003;  // 18 mm in a second
    game.step();
  }
  EXPECT_EQ(game.referee.state(), State::kWaitStop);
  EXPECT_LT(game.run_until("start").time_s, stopped_s + 7.1);
}

TEST(Paper42BallRules, PlayResumesAfterTheTimeout) {
  ScriptedGame game = in_play();
  game.kick_from(Side::kWest, 1, {1, 1.8}, {0, 4});
  const double stopped_s = game.run_until("throw_in").time_s;
  while (game.count("start_late") == 0 && game.now_s() < 60) {
    game.robot(Side::kEast, 4).position_m.x() += 0.0005;
    game.step();
  }
  EXPECT_NEAR(game.now_s(), stopped_s + 15, 1e-9);
}

// "Each robot must be at least 200 mm away from the opposing team's defense area, or an indirect
// free kick is awarded to the opposing team"
TEST(Paper42RobotRules, ARobotMayBe210MillimetresAway) {
  ScriptedGame game;
  game.line_up().kick_off();
  game.robot(Side::kEast, 2) = {2, {-3.025 + 0.8 + 0.21 + 0.09, 0}, Vec2(1, 0)};
  game.kick(Side::kWest, 1, {3, 0});
  game.run(0.5);
  EXPECT_EQ(game.count("attacker_too_close_to_defense_area"), 0);
}

TEST(Paper42RobotRules, ARobotMustNotBe190MillimetresAwayOnEitherSide) {
  for (const Side attacker : kSides) {
    ScriptedGame game;
    game.line_up().kick_off();
    const double x_m = goal_sign(attacker) * (-3.025 + 0.8 + 0.19 + 0.09);
    game.robot(attacker, 2) = {2, {x_m, 0}, Vec2(goal_sign(attacker), 0)};
    game.kick(Side::kWest, 1, {0, 3});
    game.run_until("attacker_too_close_to_defense_area", 1);
    const Command free_kick{CommandKind::kIndirectFree, opponent_of(attacker)};
    EXPECT_EQ(game.signal.next_command, free_kick);
  }
}

TEST(Paper42RobotRules, OfTwoOffendersTheKickingSidesIsJudged) {
  for (Side kicker : kSides) {
    Configuration configuration;
    configuration.first_kickoff = kicker;
    ScriptedGame game(configuration);
    game.line_up().kick_off();
    game.robot(Side::kEast, 2) = {2, {-2, 0}, Vec2(1, 0)};
    game.robot(Side::kWest, 2) = {2, {2, 0}, Vec2(-1, 0)};
    game.kick(kicker, 1, {0, 3});
    game.run_until("attacker_too_close_to_defense_area", 1);
    EXPECT_EQ(game.decisions.back().finding.robots[0].side, kicker);
  }
}

// Deviation D9: while the ball is in play, attackers may come as near as they like.
TEST(Paper42RobotRules, AnAttackerMayComeNearOnceTheBallIsInPlay) {
  ScriptedGame game = in_play();
  game.robot(Side::kWest, 2) = {2, {2.4, 0}, Vec2(1, 0)};
  game.run(2);
  EXPECT_EQ(game.count("attacker_too_close_to_defense_area"), 0);
}

TEST(Paper42RobotRules, TheFlatFrontIsNearerToTheCentreThanTheBack) {
  ScriptedGame game;
  game.line_up().kick_off();
  // Facing the area, the hull begins 75 mm from the centre: it is 205 mm away; the back would be at
  // 190.
  game.robot(Side::kEast, 2) = {2, {-3.025 + 0.8 + 0.205 + 0.075, 0}, Vec2(-1, 0)};
  game.kick(Side::kWest, 1, {3, 0});
  game.run(0.5);
  EXPECT_EQ(game.count("attacker_too_close_to_defense_area"), 0);
}

}  // namespace
}  // namespace autoref::referee
