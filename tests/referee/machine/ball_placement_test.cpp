// Ball placement by the teams' robots (2026, Ball Placement).
#include <gtest/gtest.h>

#include "tests/referee/machine/staged_machine.hpp"
#include "tests/referee/support/scripted_game.hpp"

namespace autoref::referee {
namespace {

Configuration division_b(PlacedBy placement) {
  Configuration configuration;
  configuration.field = find_game_setup("2026-b")->field;
  configuration.rules = *find_rule_book("2026-b");
  configuration.placement = placement;
  return configuration;
}

// West has kicked the ball over a touch line, so East takes a free kick. All robots are far away.
ScriptedGame after_throw_in(PlacedBy placement = PlacedBy::kTeams) {
  ScriptedGame game = in_play(division_b(placement));
  game.placement_works = false;
  game.kick(Side::kWest, 1, {0.1, 4});
  game.run_until("throw_in", 3);
  game.put_ball({0.5, 3.4});
  game.robot(Side::kWest, 1).position_m = {-2.5, -1};
  return game;
}

ScriptedGame ordered() {
  ScriptedGame game = after_throw_in();
  game.run_until("ball_placement", 3);
  return game;
}

Vec2 target_m(const ScriptedGame& game) { return game.signal.placement->target_m; }

// Puts a robot beside the ball, so that `gap_m` is free between hull and ball.
void put_beside_ball(ScriptedGame& game, Side side, double gap_m) {
  RobotObservation& robot = game.robot(side, 2);
  robot.heading = Vec2(1, 0);
  robot.position_m = game.frame.ball->position_m + Vec2(kRobotRadius_m + kBallRadius_m + gap_m, 0);
}

TEST(TransitionBallPlacement, OrdersTheTeamThatTakesTheFreeKick) {
  ScriptedGame game = after_throw_in();
  const Decision order = game.run_until("ball_placement", 3);
  EXPECT_EQ(order.command, (Command{CommandKind::kBallPlacement, Side::kEast}));
  EXPECT_EQ(order.to, State::kPlacement);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_FALSE(game.signal.placement->by_hand);
}

TEST(TransitionBallPlacement, IsNotTakenIfTheSimulatorPlacesTheBall) {
  ScriptedGame game = after_throw_in(PlacedBy::kSimulator);
  EXPECT_TRUE(game.signal.placement->by_hand);
  game.run(5);
  EXPECT_EQ(game.count("ball_placement"), 0);
}

TEST(TransitionPlacementSucceeded, FollowsABallAtRestWithin150mmAfterTwoSeconds) {
  ScriptedGame game = ordered();
  const double ordered_s = game.now_s();
  const double distance_m = (Vec2(0.5, 3.4) - target_m(game)).norm();
  game.put_ball(target_m(game) + Vec2(0.145, 0));
  const Decision success = game.run_until("placement_succeeded", 5);
  EXPECT_NEAR(success.time_s - ordered_s, 2, 0.02);
  EXPECT_NEAR(*success.finding.details.to_target_m, 0.145, 1e-9);
  EXPECT_NEAR(*success.finding.details.from_target_m, distance_m, 1e-9);
  EXPECT_EQ(success.command->kind, CommandKind::kStop);
  EXPECT_EQ(success.finding.offender, Side::kEast);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_EQ(game.run_until("start", 10).command->kind, CommandKind::kDirectFree);
}

TEST(TransitionPlacementSucceeded, DoesNotFollowABallAt155mm) {
  ScriptedGame game = ordered();
  game.put_ball(target_m(game) + Vec2(0.155, 0));
  game.run(20);
  EXPECT_EQ(game.count("placement_succeeded"), 0);
}

TEST(TransitionPlacementSucceeded, WaitsUntilAllRobotsAre50mmAwayBeforeAFreeKick) {
  ScriptedGame game = ordered();
  game.put_ball(target_m(game));
  put_beside_ball(game, Side::kEast, 0.045);
  game.run(10);
  EXPECT_EQ(game.count("placement_succeeded"), 0);
  put_beside_ball(game, Side::kEast, 0.055);
  game.run_until("placement_succeeded", 1);
}

TEST(TransitionPlacementSucceeded, WaitsUntilAllRobotsAre500mmAwayBeforeAForceStart) {
  ScriptedGame game = in_play(division_b(PlacedBy::kTeams));
  game.run_until("no_progress_in_game", 15);
  game.placement_works = false;
  game.put_ball({0.4, 2.4});
  game.run_until("ball_placement", 3);
  game.put_ball(target_m(game));
  put_beside_ball(game, Side::kEast, 0.49);
  game.run(10);
  EXPECT_EQ(game.count("placement_succeeded"), 0);
  put_beside_ball(game, Side::kEast, 0.51);
  game.run_until("placement_succeeded", 1);
}

TEST(TransitionOpponentsPlace, GivesTheOpponentsAFreeKickAfter30Seconds) {
  ScriptedGame game = ordered();
  const double ordered_s = game.now_s();
  const Decision failure = game.run_until("opponents_place", 31);
  EXPECT_NEAR(failure.time_s - ordered_s, 30, 0.02);
  EXPECT_EQ(failure.finding.event, Event::kPlacementFailed);
  EXPECT_NEAR(*failure.finding.details.to_target_m, (Vec2(0.5, 3.4) - target_m(game)).norm(), 1e-9);
  EXPECT_GT(*failure.finding.details.own_robot_to_ball_m, 1);  // all robots are far away
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kWest}));
  const Decision order = game.run_until("ball_placement", 3);
  EXPECT_EQ(order.command, (Command{CommandKind::kBallPlacement, Side::kWest}));
}

TEST(TransitionPlacementFailed, PlacesTheBallByHandForTheOriginalFreeKick) {
  ScriptedGame game = ordered();
  game.run_until("opponents_place", 31);
  const Decision failure = game.run_until("placement_failed", 32);
  EXPECT_EQ(failure.finding.offender, Side::kWest);
  EXPECT_TRUE(game.signal.placement->by_hand);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
}

TEST(BallPlacement, LastsTenSecondsLongerAfterAnInterference) {
  ScriptedGame game = ordered();
  const double ordered_s = game.now_s();
  game.robot(Side::kWest, 3).position_m = target_m(game) + Vec2(0.2, 0);
  const Decision foul = game.run_until("bot_interfered_placement", 4);
  EXPECT_NEAR(foul.time_s - ordered_s, 2, 0.05);
  EXPECT_EQ(foul.finding.offender, Side::kWest);
  EXPECT_TRUE(foul.finding.is_foul);
  game.robot(Side::kWest, 3).position_m = {-2.5, 1};
  EXPECT_NEAR(game.run_until("opponents_place", 45).time_s - ordered_s, 40, 0.02);
}

TEST(BallPlacement, CountsOneInterferenceOnly) {
  ScriptedGame game = ordered();
  game.robot(Side::kWest, 3).position_m = target_m(game) + Vec2(0.2, 0);
  game.run_until("bot_interfered_placement", 4);
  game.robot(Side::kWest, 4).position_m = target_m(game) + Vec2(-0.2, 0);
  EXPECT_FALSE(game.run_until("bot_interfered_placement", 4).finding.is_foul);
}

// "The referee has to place the ball for all kickoffs": no team places it, so nobody interferes.
TEST(BallPlacement, IsNotInterferedWithAfterAGoal) {
  for (const PlacedBy placement : {PlacedBy::kSimulator, PlacedBy::kTeams}) {
    ScriptedGame game = in_play(division_b(placement));
    game.placement_works = false;
    game.kick(Side::kWest, 1, {6, 0});
    game.run_until("goal", 3);
    game.put_ball({4.6, 0});
    game.robot(Side::kWest, 1).position_m = {3, 0.2};
    game.run(5);
    EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kPrepareKickoff, Side::kEast}));
    EXPECT_EQ(game.count("bot_interfered_placement"), 0);
  }
}

TEST(TransitionBallStays, LeavesABallNearItsPositionWhereItIs) {
  ScriptedGame game = after_throw_in();
  game.put_ball({1.2, 2.5});
  game.run_until("ball_stays", 5);
  EXPECT_EQ(target_m(game), Vec2(1.2, 2.5));
  EXPECT_EQ(game.count("ball_placement"), 0);
  EXPECT_EQ(game.run_until("start", 10).command->kind, CommandKind::kDirectFree);
}

TEST(TransitionBallByHand, PlacesABallInACornerOfTheField) {
  ScriptedGame game = after_throw_in();
  game.put_ball({5.15, 3.65});
  game.run_until("ball_by_hand", 5);
  EXPECT_TRUE(game.signal.placement->by_hand);
  EXPECT_EQ(game.count("ball_placement"), 0);
}

TEST(TransitionBallLost, PlacesABallByHandThatComesToRestBehindAGoal) {
  ScriptedGame game = ordered();
  game.put_ball({5.0, 0.1});
  game.run_until("ball_lost", 4);
  EXPECT_TRUE(game.signal.placement->by_hand);
}

TEST(BallPlacement, AwardsExitsToTheOpponentsOfATeamThatHasFailedFiveTimes) {
  StagedMachine machine(division_b(PlacedBy::kTeams));
  machine.state.placement_failures[Side::kEast] = 5;
  Finding finding;
  finding.event = Event::kThrowIn;
  finding.restart = {CommandKind::kDirectFree, Side::kEast};
  machine.put(finding);
  EXPECT_EQ(machine.state.signal.next_command, (Command{CommandKind::kDirectFree, Side::kWest}));
}

TEST(BallPlacement, KeepsOtherFreeKicksOfATeamThatHasFailedFiveTimes) {
  StagedMachine machine(division_b(PlacedBy::kTeams));
  machine.state.placement_failures[Side::kEast] = 5;
  Finding finding;
  finding.event = Event::kBotPushedBot;
  finding.restart = {CommandKind::kDirectFree, Side::kEast};
  machine.put(finding);
  EXPECT_EQ(machine.state.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
}

TEST(BoundaryCrossing, GivesTheOpponentsAFreeKickFromWhereTheBallWasKicked) {
  ScriptedGame game = in_play(division_b(PlacedBy::kSimulator));
  game.placement_works = false;
  game.kick(Side::kWest, 1, {0.1, 6});
  game.run_until("throw_in", 3);
  const Decision crossing = game.run_until("boundary_crossing", 3);
  EXPECT_EQ(crossing.finding.offender, Side::kWest);
  EXPECT_TRUE(crossing.finding.is_foul);
  EXPECT_EQ(game.signal.next_command, (Command{CommandKind::kDirectFree, Side::kEast}));
  EXPECT_NEAR(target_m(game).y(), 0.2, 0.2);
}

TEST(BoundaryCrossing, IsNotCalledForABallThatStaysInTheRunOff) {
  ScriptedGame game = in_play(division_b(PlacedBy::kSimulator));
  game.placement_works = false;
  game.kick(Side::kWest, 1, {0.1, 6});
  game.run_until("throw_in", 3);
  game.put_ball({0.5, 3.2});
  game.run(3);
  EXPECT_EQ(game.count("boundary_crossing"), 0);
}

}  // namespace
}  // namespace autoref::referee
