#include "strategies/tactics/defend.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

const std::vector<Vec2> kAttackedFrom_m = {{0, 0},       {-1, 1.2}, {-1, -1.2}, {2, 1.5},
                                           {-2.5, -1.6}, {-1.9, 0}, {1, -0.3}};

StagedPrediction staged(const Vec2& ball_m, const TeamContext& context = {}) {
  StagedPrediction stage(Play::kRunning, false, context);
  stage.world.ball(ball_m);
  stage.predicted.update(stage.world.view);
  return stage;
}

TEST(WallPosition, OfOneRobotIsOnTheLineFromTheBallToTheGoalsCentre) {
  for (const Vec2& ball_m : kAttackedFrom_m) {
    const Vec2 position_m = wall_position(staged(ball_m).predicted, 0, 1).position_m;
    EXPECT_LT(distance_to_segment(position_m, ball_m, Field{}.goal_centre_m(Side::kWest)), 20_mm)
        << ball_m.transpose();
  }
}

TEST(WallPosition, OfTwoRobotsIsOnBothSidesOfThatLine) {
  for (const Vec2& ball_m : kAttackedFrom_m) {
    const StagedPrediction stage = staged(ball_m);
    const Vec2 goal_m = Field{}.goal_centre_m(Side::kWest);
    const double first =
        cross(ball_m - goal_m, wall_position(stage.predicted, 0, 2).position_m - goal_m);
    const double second =
        cross(ball_m - goal_m, wall_position(stage.predicted, 1, 2).position_m - goal_m);
    EXPECT_LT(first * second, 0) << ball_m.transpose();
  }
}

TEST(WallPosition, LetsNoBallThroughBetweenNeighboursThatDoNotTouch) {
  for (const Vec2& ball_m : kAttackedFrom_m) {
    const StagedPrediction stage = staged(ball_m);
    for (const int count : {2, 3}) {
      for (int i = 1; i < count; ++i) {
        const double apart_m = (wall_position(stage.predicted, i, count).position_m -
                                wall_position(stage.predicted, i - 1, count).position_m)
                                   .norm();
        EXPECT_GE(apart_m, 2 * kRobotRadius_m - 1_mm) << count << ", " << ball_m.transpose();
        EXPECT_LE(apart_m, 2 * (kRobotRadius_m + kBallRadius_m)) << ball_m.transpose();
      }
    }
  }
}

TEST(WallPosition, IsJustOutsideTheAreaOfEveryRuleBook) {
  for (const char* rules : {"paper", "2014-double", "2026-b", "2026-a"}) {
    const TeamContext context = team_context_of(rules);
    for (const Vec2& ball_m : kAttackedFrom_m) {
      const StagedPrediction stage = staged(ball_m, context);
      for (const int count : {1, 2, 3}) {
        for (int i = 0; i < count; ++i) {
          const Vec2 position_m = wall_position(stage.predicted, i, count).position_m;
          const double off_m = distance_to_defence_area(context.field, Side::kWest, position_m);
          EXPECT_GE(off_m, kRobotRadius_m) << rules << ", ball at " << ball_m.transpose();
          EXPECT_LE(off_m, 0.5) << rules << ", ball at " << ball_m.transpose();
        }
      }
    }
  }
}

TEST(WallPosition, FacesTheBall) {
  const Waypoint waypoint = wall_position(staged({0, 1}).predicted, 0, 1);
  EXPECT_GT(waypoint.heading.dot((Vec2(0, 1) - waypoint.position_m).normalized()), 0.999);
}

TEST(MarkPosition, IsBetweenTheOpponentAndTheGoalOnTheBallsSide) {
  StagedPrediction stage(Play::kRunning);
  const Vec2 opponent_m(-1, 1);
  stage.world.opponent(0, opponent_m).ball({-1, -1});
  const Vec2 off = mark_position(stage.look(), 0).position_m - opponent_m;
  const Vec2 to_goal = (Field{}.goal_centre_m(Side::kWest) - opponent_m).normalized();
  EXPECT_GT(off.normalized().dot(to_goal), 0.7);
  EXPECT_GT(cross(to_goal, off), 0);  // the ball is to the left of the path to the goal
  EXPECT_GT(off.norm(), 2 * kRobotRadius_m);
  EXPECT_LT(off.norm(), 0.5);
}

TEST(DangerousOpponents, StartWithTheOneNearestToTheGoal) {
  StagedPrediction stage(Play::kRunning);
  stage.world.ball({1.5, 0}).opponent(0, {-0.5, 1}).opponent(1, {-2, -1}).opponent(2, {-1.2, 0.5});
  stage.world.opponent(3, {1.6, 0});
  const auto order = dangerous_opponents(stage.look());
  ASSERT_EQ(order.size(), 3U);
  EXPECT_EQ(order[0], 1);
  EXPECT_EQ(order[1], 2);
  EXPECT_EQ(order[2], 0);
}

TEST(DangerousOpponents, ExcludeTheOneAtTheBallAndTheirKeeper) {
  StagedPrediction stage(Play::kRunning);
  stage.world.ball({-1, 0}).opponent(0, {2.9, 0}).opponent(1, {-0.8, 0}).opponent(2, {-1, 1.3});
  const auto order = dangerous_opponents(stage.look());
  ASSERT_EQ(order.size(), 1U);
  EXPECT_EQ(order[0], 2);
}

}  // namespace
}  // namespace autoref::strategies
