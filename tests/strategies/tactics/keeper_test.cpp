#include "strategies/tactics/keeper.hpp"

#include <gtest/gtest.h>

#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

const Field kField;
constexpr double kGoal_x = -3.025;

// A keeper in its goal, and a ball with that position and velocity.
StagedPrediction staged_shot(const Vec2& ball_m, const Vec2& velocity_mps = {0, 0}) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).opponent(0, {1, 0});
  stage.world.view.ball = {ball_m, velocity_mps};
  stage.predicted.update(stage.world.view);
  return stage;
}

Vec2 position_for(const Vec2& ball_m, const Vec2& velocity_mps = {0, 0}) {
  const StagedPrediction stage = staged_shot(ball_m, velocity_mps);
  return keeper_position(stage.predicted, stage.predicted.robot(0)).position_m;
}

class KeeperAgainstBall : public testing::TestWithParam<Vec2> {};

TEST_P(KeeperAgainstBall, BisectsTheAngleOfTheGoalSeenFromTheBall) {
  const Vec2 to_keeper = position_for(GetParam()) - GetParam();
  const Vec2 to_left = Vec2(kGoal_x, kField.half_goal_m()) - GetParam();
  const Vec2 to_right = Vec2(kGoal_x, -kField.half_goal_m()) - GetParam();
  EXPECT_NEAR(angle_between(to_left, to_keeper), angle_between(to_keeper, to_right), 0.02);
}

INSTANTIATE_TEST_SUITE_P(At, KeeperAgainstBall,
                         testing::Values(Vec2(-1, 0.8), Vec2(0, -1), Vec2(-2, 0.2), Vec2(2, 1.5)),
                         name_of_place);

TEST(KeeperPosition, IsAheadOfTheLineByTheStylesDistance) {
  EXPECT_NEAR(position_for({0, 0}).x(), kGoal_x + Style{}.keeper_out_m, 0.05);
}

TEST(KeeperPosition, IsAtTheNearPostForABallBesideTheGoal) {
  const Vec2 left_m = position_for({kGoal_x + 0.1, 1.6});
  const Vec2 right_m = position_for({kGoal_x + 0.1, -1.6});
  EXPECT_NEAR(left_m.y(), kField.half_goal_m() - kRobotRadius_m, 0.05);
  EXPECT_NEAR(right_m.y(), kRobotRadius_m - kField.half_goal_m(), 0.05);
  EXPECT_LT(std::max(left_m.x(), right_m.x()), kGoal_x + 0.25);
}

// A keeper in its goal, and an opponent with the ball that faces a point.
Vec2 position_before(const Vec2& faced_m) {
  const Vec2 ball_m(-1, 0);
  StagedPrediction stage = staged_shot(ball_m);
  TrackedRobot& shooter = stage.world.view.opponents[0];
  shooter.heading = (faced_m - ball_m).normalized();
  shooter.position_m = ball_m - shooter.heading * kHeldBall_m;
  const PredictedState& predicted = stage.look();
  return keeper_position(predicted, predicted.robot(0)).position_m;
}

// How far the keeper is from the path of a shot of the opponent's ball to that point of the goal.
double off_shot_m(const Vec2& keeper_m, const Vec2& aim_m) {
  return distance_to_segment(keeper_m, {-1, 0}, aim_m);
}

TEST(KeeperPosition, ShiftsTowardsTheAimOfAnOpponentWithTheBall) {
  const Vec2 middle_m = position_before({kGoal_x, 0});
  const Vec2 right_m(kGoal_x, -0.3);
  const Vec2 left_m(kGoal_x, 0.3);
  EXPECT_LT(off_shot_m(position_before(right_m), right_m), off_shot_m(middle_m, right_m) / 2);
  EXPECT_LT(off_shot_m(position_before(left_m), left_m), off_shot_m(middle_m, left_m) / 2);
}

TEST(KeeperPosition, StaysInTheMiddleIfAnOpponentFacesElsewhere) {
  const Vec2 middle_m = position_before({kGoal_x, 0});
  EXPECT_LT((position_before({kGoal_x, 1}) - middle_m).norm(), 1_mm);
  EXPECT_LT((position_before({-1, 2}) - middle_m).norm(), 1_mm);
  EXPECT_LT((position_before({0, 0.1}) - middle_m).norm(), 1_mm);
}

// How far the keeper is from the path of a shot from (-1, 0.5) to that y of the goal line.
double off_path_of_shot_m(double y_m) {
  const Vec2 ball_m(-1, 0.5);
  const Vec2 direction = (Vec2(kGoal_x, y_m) - ball_m).normalized();
  return distance_to_segment(position_for(ball_m, direction * 4), ball_m, {kGoal_x, y_m});
}

TEST(KeeperPosition, IsInThePathOfAShot) {
  EXPECT_LT(off_path_of_shot_m(-0.3), 10_mm);
  EXPECT_LT(off_path_of_shot_m(-0.1), 10_mm);
  EXPECT_LT(off_path_of_shot_m(0.25), 10_mm);
}

// Otherwise every pass would draw the keeper away.
TEST(KeeperPosition, DoesNotFollowAShotThatGoesWide) {
  const Vec2 still_m = position_for({-1, 0.5});
  const Vec2 wide_m =
      position_for({-1, 0.5}, (Vec2(kGoal_x, 0.6) - Vec2(-1, 0.5)).normalized() * 4);
  EXPECT_LT((still_m - wide_m).norm(), 0.1);
}

void expect_keeper_before_line(const Vec2& ball_mps) {
  for (double x = kGoal_x; x < 3; x += 0.2) {
    for (double y = -2; y <= 2; y += 0.2) {
      ASSERT_GE(position_for({x, y}, ball_mps).x(), kGoal_x + kRobotRadius_m)
          << x << ", " << y << " with " << ball_mps.transpose();
    }
  }
}

TEST(KeeperPosition, IsNeverBehindItsLine) {
  expect_keeper_before_line({0, 0});
  expect_keeper_before_line({-3, 0});
  expect_keeper_before_line({-2, -2});
  expect_keeper_before_line({-2, 2});
}

TEST(IsKeepersBall, IsTrueOnlyForASlowBallInItsArea) {
  EXPECT_TRUE(is_keepers_ball(staged_shot({-2.6, 0.2}).predicted));
  EXPECT_TRUE(is_keepers_ball(staged_shot({-2.6, 0.2}, {0.8, 0}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({-2.6, 0.2}, {2, 0}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({-2, 0.2}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({2.6, 0.2}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({-3.1, 0.2}).predicted));  // in the goal
}

// Keeps the goal for one frame. Returns where the keeper is then.
Vec2 keep_goal_for_a_frame(StagedPrediction& stage) {
  stage.look(1);
  obey(stage.world.view.own[0], keep_goal(stage.predicted, 0));
  return stage.world.view.own[0].position_m;
}

// Keeps the goal until the ball reaches the keeper's front.
void keep_goal_until_ball_is_there(StagedPrediction& stage) {
  Vec2 keeper_m = stage.world.view.own[0].position_m;
  while (stage.world.view.ball.position_m.x() > keeper_m.x() + kHeldBall_m)
    keeper_m = keep_goal_for_a_frame(stage);
}

// The shot comes at 4 m/s from 2 m away, so the keeper has about 0.7 s to move 0.25 m.
TEST(KeepGoal, ReachesAShotAtACornerInTime) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).ball({-1, 0});
  const Vec2 corner_m(kGoal_x, 0.28);
  stage.world.kick((corner_m - Vec2(-1, 0)).normalized() * 4);
  keep_goal_until_ball_is_there(stage);
  EXPECT_LT(distance_to_segment(stage.world.robot(0).position_m, {-1, 0}, corner_m), 30_mm);
}

void keep_goal_for_four_seconds(StagedPrediction& stage) {
  for (int i = 0; i < 240; ++i) keep_goal_for_a_frame(stage);
}

TEST(KeepGoal, ComesBackFromTheFieldAndFacesTheBall) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {0, 1}).ball({1, -1});
  keep_goal_for_four_seconds(stage);
  const TrackedRobot& keeper = stage.world.robot(0);
  EXPECT_LT((keeper.position_m - Vec2(kGoal_x + Style{}.keeper_out_m, 0)).norm(), 0.15);
  EXPECT_GT(keeper.heading.dot((Vec2(1, -1) - keeper.position_m).normalized()), 0.99);
}

}  // namespace
}  // namespace autoref::strategies
