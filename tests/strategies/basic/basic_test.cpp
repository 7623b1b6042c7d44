#include "strategies/basic/basic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies::basic {
namespace {

class BasicInStop : public testing::TestWithParam<Vec2> {};

TEST_P(BasicInStop, StaysHalfAMetreFromTheBall) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kStop);
  world.six_against_six().view.ball.position_m = GetParam();
  world.run(team, 5);
  EXPECT_EQ(field_players_within(world, GetParam(), kBallGap_m), kNobody);
}

INSTANTIATE_TEST_SUITE_P(BallAt, BasicInStop,
                         testing::Values(Vec2(0, 0), Vec2(-2.925, 1.925), Vec2(2.925, -1.925),
                                         Vec2(-1, 1)),
                         name_of_place);

TEST(Basic, ComesToRestWhilePlayIsStopped) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kStop);
  world.six_against_six().view.ball.position_m = {1, 1};
  world.run(team, 6);
  const TeamView before = world.view;
  world.run(team, 1);
  EXPECT_EQ(moved_since(before, world, 15_mm), kNobody);
}

// Whether a robot at this position would overlap the goal's walls or its net.
bool is_in_goal_walls(const Field& field, const Vec2& robot_m) {
  const double x = std::abs(robot_m.x());
  const double back_m = field.half_length_m() + field.goal_depth_m + field.goal_wall_thickness_m;
  const double outer_m = field.half_goal_m() + field.goal_wall_thickness_m;
  return x > field.half_length_m() && x < back_m + kRobotRadius_m - 1_mm &&
         std::abs(robot_m.y()) < outer_m + kRobotRadius_m - 1_mm;
}

// Moves robot 2 for 5 s from behind a goal; stops where it overlaps the walls. Returns where it is.
Vec2 driven_from_behind_goal_m(Play play, const Vec2& start_m) {
  Basic team{TeamContext{}};
  StagedWorld world(play);
  world.six_against_six().view.ball.position_m = {0.5, -0.5};
  world.view.own[2].position_m = start_m;
  for (int f = 0; f < 300 && !is_in_goal_walls(Field{}, world.robot(2).position_m); ++f) {
    world.step(team);
  }
  return world.robot(2).position_m;
}

class BasicBehindAGoal : public testing::TestWithParam<Vec2> {};

TEST_P(BasicBehindAGoal, DrivesAroundItInOpenPlay) {
  const Vec2 end_m = driven_from_behind_goal_m(Play::kRunning, GetParam());
  EXPECT_LT(std::abs(end_m.x()), Field{}.half_length_m());
}

TEST_P(BasicBehindAGoal, DrivesAroundItInAStop) {
  const Vec2 end_m = driven_from_behind_goal_m(Play::kStop, GetParam());
  EXPECT_LT(std::abs(end_m.x()), Field{}.half_length_m());
}

INSTANTIATE_TEST_SUITE_P(From, BasicBehindAGoal,
                         testing::Values(Vec2(3.315, 0.05), Vec2(-3.315, -0.2), Vec2(3.32, -0.47)),
                         name_of_place);

// Prepares a kick-off for 6 s with one robot in the opponents' half. Returns who is not in its own.
Numbers beyond_half_at_kickoff(bool ours) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kPrepareKickoff, ours);
  world.six_against_six();
  world.view.own[5].position_m = {1.5, 0.5};
  world.run(team, 6);
  return numbers_of(world.view.own, is_beyond_own_half);
}

TEST(Basic, LinesUpInItsOwnHalfForAKickoff) {
  EXPECT_EQ(beyond_half_at_kickoff(true), kNobody);
  EXPECT_EQ(beyond_half_at_kickoff(false), kNobody);
}

TEST(Basic, KeepsItsHullClearOfTheOpponentsAreaBeforeARestart) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kDirectFree, false);
  world.six_against_six().view.ball.position_m = {2.525, 1.925};  // the opponents' goal kick
  world.view.own[3].position_m = {2.2, 0.3};
  world.run(team, 4);
  EXPECT_EQ(near_their_area(world, 200_mm + kRobotRadius_m), kNobody);
}

// Lets robot 1 play until it kicks the ball, for at most 10 s. Returns whether it did.
bool kicks_within_ten_seconds(StagedWorld& world, Basic& team) {
  for (int i = 0; i < 600; ++i) {
    const RobotCommand& command = world.step(team)[1];
    const double gap_m = (world.robot(1).position_m - world.view.ball.position_m).norm();
    if (command.kick_mps > 0 && gap_m < 0.11) return true;
  }
  return false;
}

TEST(Basic, GetsBehindTheBallAndKicksItAtTheGoal) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kRunning);
  world.own(0, {-2.9, 0}).own(1, {1.0, 0.6});
  world.view.ball.position_m = {0.5, 0.2};
  ASSERT_TRUE(kicks_within_ten_seconds(world, team));
  const Vec2 ray = world.robot(1).heading;
  const double y_at_goal = 0.2 + ray.y() / ray.x() * (3.025 - 0.5);
  EXPECT_LT(std::abs(y_at_goal), 0.35);
}

TEST(Basic, KeeperStandsWhereTheBallWillCrossTheLine) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kRunning);
  world.own(0, {-2.9, 0}).own(1, {2, 0});
  world.view.ball = {{-1, 0}, {-2, 0.25}, 0};  // crosses the line at y = 0.24
  world.run(team, 1);  // not yet long enough for the attacker to take the ball
  EXPECT_NEAR(world.robot(0).position_m.y(), 0.24, 0.03);
}

TEST(Basic, TakesItsRestartEvenWithASingleRobot) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kIndirectFree, true);
  world.own(4, {-2, -1});
  world.view.ball.position_m = {1, 1.925};
  EXPECT_LT(least_gap_m(world, team, 400 / 60.0, {1, 1.925}), 0.1);
}

// The maximum speed commanded in a stop of 5 s under that rule book.
double fastest_of_basic_mps(const char* rules) {
  TeamContext context;
  context.rules = find_rule_book(rules).value();
  Basic team{context};
  StagedWorld world(Play::kStop);
  world.six_against_six().view.ball.position_m = {-2.9, -1.9};
  double fastest_mps = 0;
  for (int f = 0; f < 300; ++f) {
    world.step(team);
    for (const TrackedRobot& robot : world.view.own) {
      fastest_mps = std::max(fastest_mps, robot.velocity_mps.norm());
    }
  }
  return fastest_mps;
}

TEST(Basic, KeepsTheSpeedLimitInAStopIfThereIsOne) {
  EXPECT_LT(fastest_of_basic_mps("2014"), 1.0);
  EXPECT_LT(fastest_of_basic_mps("2026-b"), 1.5);
  EXPECT_GT(fastest_of_basic_mps("paper"), 1.5);
}

// The ball is 700 mm in front of the team's own area, so a robot does not fit between them at a
// distance of 500 mm from the ball.
TEST(Basic, KeepsItsDistanceAtAFreeKickInFrontOfItsArea) {
  TeamContext context;
  context.rules = find_rule_book("2014").value();
  Basic team{context};
  StagedWorld world(Play::kDirectFree, false);
  world.six_against_six().view.ball.position_m = {-3.025 + 0.8 + 0.7, 0.1};
  world.run(team, 8);
  EXPECT_EQ(robots_within(world, world.view.ball.position_m, kBallGap_m), kNobody);
}

TEST(Basic, LeavesAStoppedBallWithinTwoSeconds) {
  TeamContext context;
  context.rules = find_rule_book("2014").value();
  Basic team{context};
  StagedWorld world(Play::kStop);
  world.six_against_six().view.ball.position_m = {1, 1};
  world.view.own[2].position_m = {0.9, 0.95};
  world.view.own[3].position_m = {1.1, 1.15};
  world.run(team, 2);
  EXPECT_EQ(robots_within(world, {1, 1}, kBallGap_m), kNobody);
}

// The smallest distance of the team's robots from a ball at rest in the opponents' area.
double nearest_to_ball_in_their_area_m(const char* rules) {
  TeamContext context;
  context.rules = find_rule_book(rules).value();
  Basic team{context};
  StagedWorld world(Play::kRunning);
  world.six_against_six().view.ball.position_m = {2.6, 0.1};
  double nearest_m = 9;
  for (int f = 0; f < 300; ++f) {
    world.step(team);
    for (const TrackedRobot& robot : world.view.own) {
      nearest_m = std::min(nearest_m, (robot.position_m - world.view.ball.position_m).norm());
    }
  }
  return nearest_m;
}

TEST(Basic, LeavesABallInTheOpponentsAreaAloneIfARuleRequiresIt) {
  EXPECT_GT(nearest_to_ball_in_their_area_m("2026-b"), 0.2);
  EXPECT_LT(nearest_to_ball_in_their_area_m("2014"), 0.12);
}

TEST(Basic, StandsStillInHalt) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kHalt);
  world.six_against_six();
  EXPECT_EQ(active_robots(world.step(team)), kNobody);
}

TEST(Basic, PlaysWithNoRobotsAndWithSixteen) {
  Basic team{TeamContext{}};
  StagedWorld empty(Play::kRunning);
  empty.step(team);
  StagedWorld full(Play::kRunning);
  full.rows_of(16).run(team, 3);
  EXPECT_EQ(numbers_of(full.view.own, is_nowhere), kNobody);
}

// The smallest distance from the ball, in 1 s, of the robot that has just kicked off 0.3 m ahead.
double kicker_stays_from_ball_m(const char* rules) {
  Basic team{team_context_of(rules)};
  StagedWorld world(Play::kKickoff, true);
  world.own(0, {-2.8, 0}).own(1, {-0.12, 0}).own(2, {-2.5, 1.5}).opponent(0, {2.8, 0}).ball({0, 0});
  world.step(team);
  world.view.play = Play::kRunning;
  world.ball({0.3, 0});
  double least_m = 9;
  for (int frame = 0; frame < 60; ++frame) {
    world.step(team);
    least_m = std::min(least_m, (world.robot(1).position_m - world.view.ball.position_m).norm());
  }
  return least_m;
}

TEST(Basic, DoesNotTouchTheBallTwiceAtARestart) {
  EXPECT_GT(kicker_stays_from_ball_m("2014"), 0.2);
  EXPECT_LT(kicker_stays_from_ball_m("paper"), 0.15);
}

}  // namespace
}  // namespace autoref::strategies::basic
