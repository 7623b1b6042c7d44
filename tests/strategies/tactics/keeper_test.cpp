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

TEST(KeeperPosition, BisectsTheAngleOfTheGoalSeenFromTheBall) {
  for (const Vec2& ball_m : {Vec2(-1, 0.8), Vec2(0, -1), Vec2(-2, 0.2), Vec2(2, 1.5)}) {
    const Vec2 to_keeper = position_for(ball_m) - ball_m;
    const Vec2 to_left = Vec2(kGoal_x, kField.half_goal_m()) - ball_m;
    const Vec2 to_right = Vec2(kGoal_x, -kField.half_goal_m()) - ball_m;
    EXPECT_NEAR(angle_between(to_left, to_keeper), angle_between(to_keeper, to_right), 0.02)
        << ball_m.transpose();
  }
}

TEST(KeeperPosition, IsAheadOfTheLineByTheStylesDistance) {
  EXPECT_NEAR(position_for({0, 0}).x(), kGoal_x + Style{}.keeper_out_m, 0.05);
}

TEST(KeeperPosition, IsAtTheNearPostForABallBesideTheGoal) {
  for (const double side : {1.0, -1.0}) {
    const Vec2 position_m = position_for({kGoal_x + 0.1, 1.6 * side});
    EXPECT_NEAR(position_m.y() * side, kField.half_goal_m() - kRobotRadius_m, 0.05);
    EXPECT_LT(position_m.x(), kGoal_x + 0.25);
  }
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

TEST(KeeperPosition, ShiftsTowardsTheAimOfAnOpponentWithTheBall) {
  const Vec2 middle_m = position_before({kGoal_x, 0});
  for (const double y : {-0.3, 0.3}) {
    const Vec2 faced_m(kGoal_x, y);
    const double off_m = distance_to_segment(middle_m, {-1, 0}, faced_m);
    EXPECT_LT(distance_to_segment(position_before(faced_m), {-1, 0}, faced_m), off_m / 2) << y;
  }
}

TEST(KeeperPosition, StaysInTheMiddleIfAnOpponentFacesElsewhere) {
  const Vec2 middle_m = position_before({kGoal_x, 0});
  for (const Vec2& faced_m : {Vec2(kGoal_x, 1), Vec2(-1, 2), Vec2(0, 0.1)}) {
    EXPECT_LT((position_before(faced_m) - middle_m).norm(), 1_mm) << faced_m.transpose();
  }
}

TEST(KeeperPosition, IsInThePathOfAShot) {
  for (const double y : {-0.3, -0.1, 0.25}) {
    const Vec2 ball_m(-1, 0.5);
    const Vec2 direction = (Vec2(kGoal_x, y) - ball_m).normalized();
    const Vec2 position_m = position_for(ball_m, direction * 4);
    EXPECT_LT(distance_to_segment(position_m, ball_m, {kGoal_x, y}), 10_mm) << y;
  }
}

// Otherwise every pass would draw the keeper away.
TEST(KeeperPosition, DoesNotFollowAShotThatGoesWide) {
  const Vec2 still_m = position_for({-1, 0.5});
  const Vec2 wide_m =
      position_for({-1, 0.5}, (Vec2(kGoal_x, 0.6) - Vec2(-1, 0.5)).normalized() * 4);
  EXPECT_LT((still_m - wide_m).norm(), 0.1);
}

TEST(KeeperPosition, IsNeverBehindItsLine) {
  for (double x = kGoal_x; x < 3; x += 0.2) {
    for (double y = -2; y <= 2; y += 0.2) {
      for (const Vec2& velocity_mps : {Vec2(0, 0), Vec2(-3, 0), Vec2(-2, -2), Vec2(-2, 2)}) {
        ASSERT_GE(position_for({x, y}, velocity_mps).x(), kGoal_x + kRobotRadius_m)
            << x << ", " << y << " with " << velocity_mps.transpose();
      }
    }
  }
}

TEST(IsKeepersBall, IsTrueOnlyForASlowBallInItsArea) {
  EXPECT_TRUE(is_keepers_ball(staged_shot({-2.6, 0.2}).predicted));
  EXPECT_TRUE(is_keepers_ball(staged_shot({-2.6, 0.2}, {0.8, 0}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({-2.6, 0.2}, {2, 0}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({-2, 0.2}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({2.6, 0.2}).predicted));
  EXPECT_FALSE(is_keepers_ball(staged_shot({-3.1, 0.2}).predicted));  // in the goal
}

// The shot comes at 4 m/s from 2 m away, so the keeper has about 0.7 s to move 0.25 m.
TEST(KeepGoal, ReachesAShotAtACornerInTime) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {-2.8, 0}).ball({-1, 0});
  const Vec2 corner_m(kGoal_x, 0.28);
  stage.world.kick((corner_m - Vec2(-1, 0)).normalized() * 4);
  TrackedRobot& keeper = stage.world.view.own[0];
  while (stage.world.view.ball.position_m.x() > keeper.position_m.x() + kHeldBall_m) {
    stage.look(1);
    obey(keeper, keep_goal(stage.predicted, 0));
  }
  EXPECT_LT(distance_to_segment(keeper.position_m, {-1, 0}, corner_m), 30_mm);
}

TEST(KeepGoal, ComesBackFromTheFieldAndFacesTheBall) {
  StagedPrediction stage(Play::kRunning);
  stage.world.own(0, {0, 1}).ball({1, -1});
  TrackedRobot& keeper = stage.world.view.own[0];
  for (int i = 0; i < 240; ++i) {
    stage.look(1);
    obey(keeper, keep_goal(stage.predicted, 0));
  }
  EXPECT_LT((keeper.position_m - Vec2(kGoal_x + Style{}.keeper_out_m, 0)).norm(), 0.15);
  EXPECT_GT(keeper.heading.dot((Vec2(1, -1) - keeper.position_m).normalized()), 0.99);
}

}  // namespace
}  // namespace autoref::strategies
