#include "strategies/basic/basic.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies::basic {
namespace {

TEST(Basic, StaysHalfAMetreFromTheBallWhilePlayIsStopped) {
  Basic team{TeamContext{}};
  for (const Vec2& ball_m : {Vec2(0, 0), Vec2(-2.925, 1.925), Vec2(2.925, -1.925), Vec2(-1, 1)}) {
    StagedWorld world(Play::kStop);
    world.six_against_six().view.ball.position_m = ball_m;
    world.run(team, 5);
    for (const TrackedRobot& robot : world.view.own) {
      if (robot.number == 0) continue;  // the keeper may stay in its goal
      EXPECT_GE((robot.position_m - ball_m).norm(), kBallGap_m) << "robot " << robot.number;
    }
  }
}

TEST(Basic, ComesToRestWhilePlayIsStopped) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kStop);
  world.six_against_six().view.ball.position_m = {1, 1};
  world.run(team, 6);
  const TeamView before = world.view;
  world.run(team, 1);
  for (std::size_t i = 0; i < before.own.size(); ++i) {
    EXPECT_LT((world.view.own[i].position_m - before.own[i].position_m).norm(), 15_mm) << i;
  }
}

// Whether a robot at this position would overlap the goal's walls or its net.
bool is_in_goal_walls(const Field& field, const Vec2& robot_m) {
  const double x = std::abs(robot_m.x());
  const double back_m = field.half_length_m() + field.goal_depth_m + field.goal_wall_thickness_m;
  const double outer_m = field.half_goal_m() + field.goal_wall_thickness_m;
  return x > field.half_length_m() && x < back_m + kRobotRadius_m - 1_mm &&
         std::abs(robot_m.y()) < outer_m + kRobotRadius_m - 1_mm;
}

TEST(Basic, DrivesAroundAGoalFromBehindIt) {
  const Field field;
  Basic team{TeamContext{}};
  for (const Play play : {Play::kRunning, Play::kStop}) {
    for (const Vec2& start_m : {Vec2(3.315, 0.05), Vec2(-3.315, -0.2), Vec2(3.32, -0.47)}) {
      StagedWorld world(play);
      world.six_against_six().view.ball.position_m = {0.5, -0.5};
      world.view.own[2].position_m = start_m;
      for (int f = 0; f < 300; ++f) {
        world.step(team);
        ASSERT_FALSE(is_in_goal_walls(field, world.robot(2).position_m))
            << start_m.transpose() << ", frame " << f;
      }
      EXPECT_LT(std::abs(world.robot(2).position_m.x()), field.half_length_m());
    }
  }
}

TEST(Basic, LinesUpInItsOwnHalfForAKickoff) {
  Basic team{TeamContext{}};
  for (const bool ours : {true, false}) {
    StagedWorld world(Play::kPrepareKickoff, ours);
    world.six_against_six();
    world.view.own[5].position_m = {1.5, 0.5};
    world.run(team, 6);
    for (const TrackedRobot& robot : world.view.own) {
      EXPECT_LE(robot.position_m.x(), -kRobotRadius_m) << robot.number;
    }
  }
}

TEST(Basic, KeepsItsHullClearOfTheOpponentsAreaBeforeARestart) {
  Basic team{TeamContext{}};
  const Field field;
  StagedWorld world(Play::kDirectFree, false);
  world.six_against_six().view.ball.position_m = {2.525, 1.925};  // the opponents' goal kick
  world.view.own[3].position_m = {2.2, 0.3};
  world.run(team, 4);
  for (const TrackedRobot& robot : world.view.own) {
    EXPECT_GE(distance_to_defence_area(field, Side::kEast, robot.position_m),
              200_mm + kRobotRadius_m)
        << robot.number;
  }
}

TEST(Basic, GetsBehindTheBallAndKicksItAtTheGoal) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kRunning);
  world.own(0, {-2.9, 0}).own(1, {1.0, 0.6});
  world.view.ball.position_m = {0.5, 0.2};
  const RobotCommand* kick = nullptr;
  for (int i = 0; i < 600 && kick == nullptr; ++i) {
    const RobotCommand& command = world.step(team)[1];
    const double gap_m = (world.robot(1).position_m - world.view.ball.position_m).norm();
    if (command.kick_mps > 0 && gap_m < 0.11) kick = &command;
  }
  ASSERT_NE(kick, nullptr);
  const Vec2 ray = world.robot(1).heading;
  const double y_at_goal = 0.2 + ray.y() / ray.x() * (3.025 - 0.5);
  EXPECT_LT(std::abs(y_at_goal), 0.35);
}

TEST(Basic, KeeperStandsWhereTheBallWillCrossTheLine) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kRunning);
  world.own(0, {-2.9, 0}).own(1, {2, 0});
  world.view.ball = {{-1, 0}, {-2, 0.25}, 0};  // crosses the line at y = 0.24
  world.run(team, 2);
  EXPECT_NEAR(world.robot(0).position_m.y(), 0.24, 0.03);
}

TEST(Basic, TakesItsRestartEvenWithASingleRobot) {
  Basic team{TeamContext{}};
  StagedWorld world(Play::kIndirectFree, true);
  world.own(4, {-2, -1});
  world.view.ball.position_m = {1, 1.925};
  double nearest_m = 10;
  for (int i = 0; i < 400; ++i) {
    world.step(team);
    nearest_m = std::min(nearest_m, (world.robot(4).position_m - Vec2(1, 1.925)).norm());
  }
  EXPECT_LT(nearest_m, 0.1);
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
  for (const TrackedRobot& robot : world.view.own) {
    EXPECT_GE((robot.position_m - world.view.ball.position_m).norm(), kBallGap_m) << robot.number;
  }
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
  for (const TrackedRobot& robot : world.view.own) {
    EXPECT_GE((robot.position_m - Vec2(1, 1)).norm(), kBallGap_m) << robot.number;
  }
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
  for (const RobotCommand& command : world.step(team)) {
    EXPECT_EQ(command.velocity_mps, Vec2(0, 0));
    EXPECT_EQ(command.kick_mps, 0);
  }
}

TEST(Basic, PlaysWithNoRobotsAndWithSixteen) {
  Basic team{TeamContext{}};
  StagedWorld empty(Play::kRunning);
  empty.step(team);
  StagedWorld full(Play::kRunning);
  for (int i = 0; i < 16; ++i) {
    full.own(i, {-2.5 + 0.3 * i, 1.0});
    full.opponent(i, {-2.5 + 0.3 * i, -1.0});
  }
  full.run(team, 3);
  for (const TrackedRobot& robot : full.view.own) EXPECT_TRUE(is_finite(robot.position_m));
}

}  // namespace
}  // namespace autoref::strategies::basic
