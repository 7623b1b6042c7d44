// What a style can do against fouls: distances from areas, contact with opponents, dribbling.
#include <gtest/gtest.h>

#include <algorithm>

#include "strategies/plays/plays.hpp"
#include "strategies/tactics/areas.hpp"
#include "strategies/tactics/handle_ball.hpp"
#include "strategies/tactics/penalty.hpp"
#include "strategies/tactics/place_ball.hpp"
#include "strategies/teams/playbooks.hpp"
#include "tests/strategies/staged_play.hpp"

namespace autoref::strategies {
namespace {

Style careful() { return cobalt_playbook().style; }

StagedPlay staged_2026(Play play, bool ours = false, const Style& style = careful()) {
  return StagedPlay(play, ours, team_context_of("2026-b"), style);
}

// The least distance from the opponents' area on the way to `target_m`.
double nearest_to_area_m(StagedPlay& stage, const Vec2& target_m) {
  double nearest_m = 9;
  for (int frame = 0; frame < 300; ++frame) {
    stage.look(1);
    TrackedRobot& robot = stage.world.view.own[1];
    obey(robot, go_to(stage.predicted, 1, {target_m, Vec2(1, 0)}));
    nearest_m = std::min(nearest_m, distance_to_defence_area(stage.predicted.field(), Side::kEast,
                                                             robot.position_m));
  }
  EXPECT_LT((stage.world.view.own[1].position_m - target_m).norm(), 0.1);
  return nearest_m - kRobotRadius_m;
}

// The area of Division B is 1 m deep and 2 m wide.
double nearest_to_box_in_stop_m(const Vec2& target_m) {
  StagedPlay stage = staged_2026(Play::kStop);
  stage.world.own(0, {-4, 0}).own(1, {2.5, 0.2}).ball({-2, 0});
  return nearest_to_area_m(stage, target_m);
}

TEST(AvoidingFouls, RobotsKeepTheirDistanceFromTheCornersOfABoxDuringAStop) {
  EXPECT_GE(nearest_to_box_in_stop_m({4.2, 1.6}), 0.2);
  EXPECT_GE(nearest_to_box_in_stop_m({3, -1.8}), 0.2);
}

TEST(AvoidingFouls, ARobotInTheOpponentsAreaLeavesItTheShortestWayDuringAStop) {
  StagedPlay stage = staged_2026(Play::kStop);
  stage.world.own(0, {-4, 0}).own(1, {3.9, 0.8}).ball({-2, 0});
  stage.look();
  // Its place is beyond the area, but the touch line's side is 0.2 m away.
  const RobotCommand command = go_to(stage.predicted, 1, {Vec2(0, -2), Vec2(1, 0)});
  EXPECT_GT(command.velocity_mps.y(), 0.3);
}

TEST(AvoidingFouls, ARobotBacksStraightOutOfTheGoal) {
  StagedPlay stage = staged_2026(Play::kStop);
  stage.world.own(0, {-4, 0}).own(1, {4.55, 0.3}).ball({-2, 0});
  stage.look();
  const RobotCommand command = go_to(stage.predicted, 1, {Vec2(-1, -2), Vec2(1, 0)});
  EXPECT_LT(command.velocity_mps.x(), -0.3);
  EXPECT_LT(std::abs(command.velocity_mps.y()), 0.1);
}

TEST(AvoidingFouls, ARobotInTheGoalFirstMovesAsideOfAnOpponentThatBlocksItsWayOut) {
  StagedPlay stage = staged_2026(Play::kStop);
  stage.world.own(0, {-4, 0}).own(1, {4.43, 0.3}).opponent(0, {4.23, 0.32}).ball({-2, 0});
  stage.look();
  const RobotCommand command = go_to(stage.predicted, 1, {Vec2(-1, 2), Vec2(1, 0)});
  EXPECT_LT(command.velocity_mps.y(), -0.3);
  EXPECT_NEAR(command.velocity_mps.x(), 0, 0.1);
}

TEST(AvoidingFouls, ARobotInContactDoesNotPressAgainstAnOpponent) {
  StagedPlay stage = staged_2026(Play::kRunning);
  stage.world.own(0, {-4, 0}).own(1, {0, 0}).opponent(0, {2 * kRobotRadius_m, 0}).ball({1, 1});
  stage.look();
  RobotCommand command;
  command.velocity_mps = {0.5, 0.4};
  ease_off(stage.predicted, 1, command);
  EXPECT_LT(command.velocity_mps.x(), 0.01);
  EXPECT_NEAR(command.velocity_mps.y(), 0.4, 0.01);
}

// What is left of a velocity of 3 m/s towards the area on that side (1: the opponents').
Vec2 permitted_before_area_mps(double side) {
  StagedPlay stage = staged_2026(Play::kRunning);
  stage.world.own(0, {-4, 0}).own(1, {side * 3.3, 0}).opponent(0, {0, 2}).ball({0, 1});
  stage.look();
  RobotCommand command;
  command.velocity_mps = {side * 3, 0.5};
  stay_out_of_areas(stage.predicted, 1, command);
  return command.velocity_mps;
}

TEST(AvoidingFouls, AFieldPlayerStopsBeforeBothAreas) {
  EXPECT_LT(std::abs(permitted_before_area_mps(1).x()), 1.0);
  EXPECT_LT(std::abs(permitted_before_area_mps(-1).x()), 1.0);
  EXPECT_NEAR(permitted_before_area_mps(1).y(), 0.5, 0.01);
  EXPECT_NEAR(permitted_before_area_mps(-1).y(), 0.5, 0.01);
}

TEST(AvoidingFouls, TheKeeperAwaitsAPenaltyKickOnItsLine) {
  StagedPlay stage = staged_2026(Play::kPreparePenalty);
  stage.world.six_against_six().ball({-1.5, 0});
  const RoleAssignment assignment = stage.assignment(penalty);
  EXPECT_EQ(assignment.task(0).role, Role::kGoalLine);
  EXPECT_LT(assignment.task(0).waypoint.position_m.x(), -4.4);
}

// The robot and an opponent hold the ball between them and move 1 m.
bool lets_go_after(double path_m, const Style& style) {
  StagedPlay stage = staged_2026(Play::kRunning, false, style);
  stage.world.own(0, {-4, 0}).own(1, {0, 0}).opponent(0, {2 * kHeldBall_m, 0});
  for (double x = 0; x <= path_m; x += 0.02) {
    stage.world.view.own[1].position_m = {-x, 0};
    stage.world.view.opponents[0].position_m = {2 * kHeldBall_m - x, 0};
    stage.world.ball({kHeldBall_m - x, 0});
    stage.look(1);
    stage.handler.update();
  }
  return stage.handler.must_let_go(1);
}

TEST(AvoidingFouls, ARobotLetsGoOfABallThatItHasDribbledFarTogetherWithAnOpponent) {
  EXPECT_FALSE(lets_go_after(0.3, careful()));
  EXPECT_TRUE(lets_go_after(0.9, careful()));
  EXPECT_FALSE(lets_go_after(0.9, cobalt1_playbook().style));
}

TEST(AvoidingFouls, RobotsClearThePathOfABallThatTheRefereePlacesForTheOpponents) {
  StagedPlay stage = staged_2026(Play::kStop);
  stage.world.own(0, {-4, 0}).own(1, {0.1, 0.1}).ball({2, 0}).view.placement_m = Vec2(-2, 0);
  stage.world.view.next = CommandKind::kDirectFree;
  stage.look();
  EXPECT_TRUE(must_clear_placement(stage.predicted));
  stage.world.view.next_is_ours = true;
  stage.look();
  EXPECT_FALSE(must_clear_placement(stage.predicted));
}

// Whether a restart's taker, far from all team-mates, decides to take the ball along.
bool dribbles_from_restart(const char* rules) {
  StagedPlay stage(Play::kIndirectFree, true, team_context_of(rules), careful());
  stage.world.own(0, {-2.8, 0}).own(1, {-1, 1.8}).opponent(0, {2.8, 0}).ball({-0.8, 1.8});
  for (int frame = 0; frame < 4; ++frame) {
    stage.watch(1);
    stage.handler.play(1);
  }
  return stage.handler.choice().strike.dribble;
}

TEST(Restarts, AreDribbledOnlyIfTheRulesAllowTheTakerASecondTouch) {
  EXPECT_TRUE(dribbles_from_restart("paper"));
  EXPECT_FALSE(dribbles_from_restart("2014"));
  EXPECT_FALSE(dribbles_from_restart("2026-b"));
}

TEST(AvoidingFouls, IsCommonToAllTeamsButThePreviousCobalt) {
  for (const TeamPlaybook& team :
       {counter_playbook(), possession_playbook(), shadow_playbook(), zone_playbook()})
    EXPECT_TRUE(lets_go_after(0.8, team.style));
}

}  // namespace
}  // namespace autoref::strategies
