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

class WallAgainst : public testing::TestWithParam<Vec2> {
 protected:
  Vec2 position_m(int index, int count) const {
    return wall_position(stage.predicted, index, count).position_m;
  }
  // The distance between neighbours of that wall.
  double apart_m(int index, int count) const {
    return (position_m(index, count) - position_m(index - 1, count)).norm();
  }

  StagedPrediction stage = staged(GetParam());
  Vec2 goal_m = Field{}.goal_centre_m(Side::kWest);
};

TEST_P(WallAgainst, OfOneRobotIsOnTheLineFromTheBallToTheGoalsCentre) {
  EXPECT_LT(distance_to_segment(position_m(0, 1), GetParam(), goal_m), 20_mm);
}

TEST_P(WallAgainst, OfTwoRobotsIsOnBothSidesOfThatLine) {
  const double first = cross(GetParam() - goal_m, position_m(0, 2) - goal_m);
  const double second = cross(GetParam() - goal_m, position_m(1, 2) - goal_m);
  EXPECT_LT(first * second, 0);
}

TEST_P(WallAgainst, LetsNoBallThroughBetweenNeighboursThatDoNotTouch) {
  const auto [least_m, most_m] = std::minmax({apart_m(1, 2), apart_m(1, 3), apart_m(2, 3)});
  EXPECT_GE(least_m, 2 * kRobotRadius_m - 1_mm);
  EXPECT_LE(most_m, 2 * (kRobotRadius_m + kBallRadius_m));
}

INSTANTIATE_TEST_SUITE_P(BallAt, WallAgainst, testing::ValuesIn(kAttackedFrom_m), name_of_place);

class WallUnder : public testing::TestWithParam<const char*> {};

void expect_wall_just_outside_area(const TeamContext& context, int count) {
  for (const Vec2& ball_m : kAttackedFrom_m) {
    const StagedPrediction stage = staged(ball_m, context);
    for (int i = 0; i < count; ++i) {
      const Vec2 position_m = wall_position(stage.predicted, i, count).position_m;
      const double off_m = distance_to_defence_area(context.field, Side::kWest, position_m);
      EXPECT_GE(off_m, kRobotRadius_m) << "ball at " << ball_m.transpose();
      EXPECT_LE(off_m, 0.5) << "ball at " << ball_m.transpose();
    }
  }
}

TEST_P(WallUnder, IsJustOutsideTheArea) {
  expect_wall_just_outside_area(team_context_of(GetParam()), 1);
  expect_wall_just_outside_area(team_context_of(GetParam()), 2);
  expect_wall_just_outside_area(team_context_of(GetParam()), 3);
}

INSTANTIATE_TEST_SUITE_P(Books, WallUnder,
                         testing::Values("paper", "2014-double", "2026-b", "2026-a"),
                         name_of_rule_book);

TEST(WallPosition, FacesTheBall) {
  const Waypoint waypoint = wall_position(staged({0, 1}).predicted, 0, 1);
  EXPECT_GT(waypoint.heading.dot((Vec2(0, 1) - waypoint.position_m).normalized()), 0.999);
}

// The opponents' free kick in front of the team's area, `away_m` from it.
StagedPrediction free_kick_before_area(const char* book, double away_m, double y_m = 0) {
  const TeamContext context = team_context_of(book);
  StagedPrediction stage(Play::kDirectFree, false, context);
  const double front_m = context.field.defence_area.depth_m + away_m;
  stage.world.ball({front_m - context.field.half_length_m(), y_m});
  stage.predicted.update(stage.world.view);
  return stage;
}

// Laws of 2014: opponents keep 500 mm from the ball, and no robot is inside the area.
void expect_lawful(const StagedPrediction& stage, const Vec2& position_m) {
  const Field& field = stage.predicted.field();
  const double to_ball_m = (position_m - stage.predicted.position_m()).norm();
  EXPECT_GE(to_ball_m, 0.5 + kBallRadius_m + kRobotRadius_m);
  EXPECT_GE(distance_to_defence_area(field, Side::kWest, position_m), kRobotRadius_m);
}

TEST(SplitWall, StandsOnBothSidesOfAShotThatNoRobotCanBlock) {
  for (const double y_m : {0.0, 0.1, -0.1}) {
    const StagedPrediction stage = free_kick_before_area("2014-double", 0.7, y_m);
    ASSERT_TRUE(stage.predicted.has_no_room_behind_kick());
    const Vec2 left_m = split_wall_position(stage.predicted, 0).position_m;
    const Vec2 right_m = split_wall_position(stage.predicted, 1).position_m;
    const Vec2 next_m = split_wall_position(stage.predicted, 2).position_m;
    for (const Vec2& position_m : {left_m, right_m, next_m}) expect_lawful(stage, position_m);
    // The keeper can cover the gap, which is narrower than a robot.
    EXPECT_LT((left_m - right_m).norm(), 4 * kRobotRadius_m);
    EXPECT_GE((left_m - next_m).norm(), 2 * kRobotRadius_m);
    const Vec2 shot_m = stage.predicted.field().goal_centre_m(Side::kWest);
    const Vec2& ball_m = stage.predicted.position_m();
    EXPECT_LT(cross(shot_m - ball_m, left_m - ball_m) * cross(shot_m - ball_m, right_m - ball_m),
              0);
  }
}

TEST(WallPosition, IsBehindAFreeKickIfARobotFitsThere) {
  for (const double away_m : {0.73, 0.76, 0.8, 0.9}) {
    const StagedPrediction stage = free_kick_before_area("2014-double", away_m);
    EXPECT_FALSE(stage.predicted.has_no_room_behind_kick());
    const Vec2& ball_m = stage.predicted.position_m();
    const Vec2 position_m =
        permitted_by_all(stage.predicted.field(), wall_position(stage.predicted, 0, 1).position_m,
                         ball_m, stage.predicted.limits());
    expect_lawful(stage, position_m);
    EXPECT_NEAR(position_m.y(), 0, 30_mm) << away_m;
  }
}

TEST(WallPosition, KeepsItsMarginsWhereFreeKicksAreFarFromTheArea) {
  for (const char* book : {"2026-b", "paper"}) {
    const StagedPrediction stage = free_kick_before_area(book, 0.7);
    EXPECT_FALSE(stage.predicted.has_no_room_behind_kick());
    EXPECT_EQ(stage.predicted.limits().own_area_margin_m, kLimitMargin_m);
  }
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
