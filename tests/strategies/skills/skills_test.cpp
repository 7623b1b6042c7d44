#include <gtest/gtest.h>

#include "soccer/random.hpp"
#include "strategies/registry.hpp"
#include "strategies/skills/motion.hpp"
#include "strategies/skills/openings.hpp"
#include "strategies/skills/prediction.hpp"
#include "tests/strategies/skills/staged_bodies.hpp"

namespace autoref::strategies {
namespace {

void drive_for_three_seconds(TrackedRobot& robot, const Waypoint& waypoint) {
  for (int i = 0; i < 180; ++i) obey(robot, drive_to(robot, waypoint, {}, {}));
}

TEST(DriveTo, StopsAtItsGoalWithTheRequestedHeading) {
  TrackedRobot robot = robot_at({0, 0});
  drive_for_three_seconds(robot, {{1, -0.5}, {0, 1}});
  EXPECT_NEAR((robot.position_m - Vec2(1, -0.5)).norm(), 0, 10_mm);
  EXPECT_GT(robot.heading.y(), 0.999);
}

TEST(SteerAround, GoesStraightIfNothingIsInTheWay) {
  const Obstacles beside = {{{0.5, 0.4}, 0.2}, {{-0.3, 0}, 0.2}, {{3, 0}, 0.2}};
  EXPECT_EQ(steer_around({0, 0}, {1, 0}, beside), Vec2(1, 0));
}

TEST(SteerAround, PassesAnObstacleOnTheFreeSideWithItsClearance) {
  const Obstacles obstacle = {{{0.5, 0.05}, 0.2}};
  const Vec2 steer_m = steer_around({0, 0}, {1, 0}, obstacle);
  EXPECT_LT(steer_m.y(), 0);
  EXPECT_GE((steer_m - Vec2(0.5, 0.05)).norm(), 0.2);
}

TEST(BallAfter, SlowsDownAndStops) {
  const TrackedBall ball{{0, 0}, {1, 0}, 0};
  EXPECT_NEAR(ball_after(ball, 1).x(), 0.75, 1e-12);  // v t - a t^2 / 2 with a = 0.5 m/s^2
  EXPECT_NEAR(ball_after(ball, 10).x(), 1.0, 1e-12);  // v^2 / (2 a)
}

TEST(Intercept, MeetsARollingBallAheadOfItsPosition) {
  const Interception interception = intercept(robot_at({2, 1}), {{0, 0}, {2, 0}, 0});
  EXPECT_GT(interception.point_m.x(), 0.5);
  EXPECT_LT(interception.point_m.x(), 2.5);
}

TEST(Lane, FindsNoPointBeyondADistanceThatIsNearer) {
  RandomStream random(3);
  const auto point = [&] { return Vec2(6 * random.uniform(), 4 * random.uniform()); };
  int beyond = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 from_m = point();
    const Vec2 to_m = point();
    const Vec2 point_m = point();
    const Lane lane(from_m, to_m);
    const double distance_m = random.uniform();
    if (!lane.is_beyond(point_m, square(distance_m))) continue;
    ++beyond;
    EXPECT_GT((point_m - lane.nearest_m(point_m)).norm(), distance_m);
  }
  EXPECT_GT(beyond, 300);
}

TEST(LaneClearance, IsTheDistanceOfTheNearestRobotFromTheSegment) {
  StagedWorld world(Play::kRunning);
  world.own(0, {1, 0.6}).own(1, {2, -0.4}).own(2, {3.5, 0}).own(3, {-2, 0.1});
  EXPECT_NEAR(lane_clearance_m({0, 0}, {3, 0}, world.view.own), 0.4, 1e-12);
  EXPECT_NEAR(lane_clearance_m({0, 0}, {3.2, 0}, world.view.own), 0.3, 1e-12);
}

TEST(BestShot, AimsAtTheSideThatTheKeeperLeavesOpen) {
  StagedWorld world(Play::kRunning);
  world.opponent(0, {2.9, 0.2});
  const Aim aim = best_shot(Field{}, {1, 0}, world.view.opponents);
  EXPECT_LT(aim.target_m.y(), 0);
  EXPECT_GT(aim.clearance_m, kRobotRadius_m + kBallRadius_m);
}

TEST(Registry, FindsTeamsByNameOrReturnsNull) {
  ASSERT_NE(find_strategy("basic"), nullptr);
  ASSERT_NE(find_strategy("dummy"), nullptr);
  EXPECT_EQ(find_strategy("nobody"), nullptr);
  EXPECT_NE(find_strategy("basic")->make(TeamContext{}), nullptr);
}

}  // namespace
}  // namespace autoref::strategies
