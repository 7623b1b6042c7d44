#include "strategies/skills/motion.hpp"

#include <gtest/gtest.h>

#include "soccer/random.hpp"
#include "tests/strategies/skills/staged_bodies.hpp"
#include "tests/strategies/staged_world.hpp"

namespace autoref::strategies {
namespace {

constexpr double kClear_m = 0.21;
constexpr double kTouching_m = 2 * kRobotRadius_m;

TEST(SteerFor, GoesStraightIfThePathIsFree) {
  const Obstacles beside = {{{0.5, 0.5}, kClear_m}, {{-0.4, 0}, kClear_m}, {{1.6, 0}, kClear_m}};
  EXPECT_EQ(steer_for(robot_at({0, 0}), {1, 0}, beside), Vec2(1, 0));
  EXPECT_EQ(steer_for(robot_at({0, 0}), {1, 0}, {}), Vec2(1, 0));
}

// How far left of a robot at that point, on the way to (1.5, 0), the other one steers.
double steered_left_of_m(const Vec2& there_m) {
  const Vec2 steer_m = steer_for(robot_at({0, 0}), {1.5, 0}, {{there_m, kClear_m}});
  EXPECT_GE(distance_to_segment(there_m, {0, 0}, steer_m), kTouching_m);
  EXPECT_GE((steer_m - there_m).norm(), kClear_m);
  return steer_m.y();
}

TEST(SteerFor, PassesARobotOnTheNearerSideWithRoom) {
  EXPECT_LT(steered_left_of_m({0.7, 0.08}), 0);
  EXPECT_GT(steered_left_of_m({0.7, -0.08}), 0);
}

TEST(SteerFor, ContinuesOnTheSideOnWhichTheRobotAlreadyMoves) {
  const Obstacles ahead = {{{0.7, 0}, kClear_m}};
  EXPECT_GT(steer_for(robot_at({0, 0}, {1.5, 1.5}), {1.5, 0}, ahead).y(), 0);
  EXPECT_LT(steer_for(robot_at({0, 0}, {1.5, -1.5}), {1.5, 0}, ahead).y(), 0);
}

// From a distance of 0.4 m, there is a tangent that passes a robot without contact.
TEST(SteerFor, NeverLeadsThroughALoneRobot) {
  RandomStream random(1);
  for (int i = 0; i < 3000; ++i) {
    const double distance_m = 0.4 + 0.6 * random.uniform();
    const double beyond_m = 0.4 + random.uniform();
    const double bend_rad = 0.6 * (random.uniform() - 0.5);
    const Vec2 target_m = Vec2(distance_m, 0) + beyond_m * heading_of(bend_rad);
    const Vec2 there_m(distance_m, 0);
    const Vec2 steer_m = steer_for(robot_at({0, 0}), target_m, {{there_m, kClear_m}});
    ASSERT_GE(distance_to_segment(there_m, {0, 0}, steer_m), kTouching_m)
        << distance_m << " m ahead, target " << target_m.transpose();
  }
}

// Robots that drive along a wall, which their centres can approach to y = 2.1.
TEST(SteerFor, PassesARobotAtAWallOnTheFieldsSide) {
  Obstacles ahead = {{{0.7, 1.98}, kClear_m}};
  EXPECT_GT(steer_for(robot_at({0, 2}), {1.5, 2}, ahead).y(), 2);
  ahead.farthest_m = {9, 2.1};
  EXPECT_LT(steer_for(robot_at({0, 2}), {1.5, 2}, ahead).y(), 2);
}

// As on the way round a ball that the rules keep it away from, from just inside that distance.
TEST(SteerFor, GoesRoundTheFieldsSideOfAnObstacleThatItHasJustTouched) {
  Obstacles ahead = {{{0.59, 1.7}, 0.6}};
  ahead.farthest_m = {9, 2.1};
  EXPECT_LT(steer_for(robot_at({0, 1.72}), {1.2, 1.9}, ahead).y(), 1.7);
  EXPECT_LT(steer_around({0, 1.72}, {1.2, 1.9}, ahead).y(), 1.7);
}

// As between a wall and a ball that the rules keep it away from.
TEST(SteerFor, GoesAlongTheWallIfItIsAlreadyTooNearToTheObstacle) {
  Obstacles beside = {{{0.2, 1.7}, 0.6}};
  beside.farthest_m = {9, 2.1};
  for (const Vec2& steer_m :
       {steer_for(robot_at({0, 2}), {1.5, 2}, beside), steer_around({0, 2}, {1.5, 2}, beside)}) {
    EXPECT_NEAR(steer_m.y(), 2.1, 1e-9);
    EXPECT_GT(steer_m.x(), 0);
  }
}

TEST(SteerAround, PassesARobotAtAWallOnTheFieldsSide) {
  Obstacles ahead = {{{0.7, 1.98}, kClear_m}};
  EXPECT_GT(steer_around({0, 2}, {1.5, 2}, ahead).y(), 2);
  ahead.farthest_m = {9, 2.1};
  EXPECT_LT(steer_around({0, 2}, {1.5, 2}, ahead).y(), 2);
}

TEST(FindObstacles, FindsEveryOtherRobotNearThePath) {
  const TrackedRobots own = {robot_at({0, 0}), numbered(1, robot_at({1, 0.1}))};
  const TrackedRobots opponents = {robot_at({0.5, 0}), numbered(1, robot_at({0.5, 1.7}))};
  Obstacles obstacles;
  find_obstacles({own, opponents}, own[0], {2, 0}, obstacles);
  EXPECT_EQ(obstacles.size(), 2U);
}

TEST(FindObstacles, KeepsTheRequestedDistanceFromHullToBall) {
  const TrackedRobots own = {robot_at({0, 0})};
  Obstacles obstacles;
  find_obstacles({own, {}, 0.5, {1, 0}}, own[0], {2, 0}, obstacles);
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_EQ(obstacles[0].position_m, Vec2(1, 0));
  EXPECT_NEAR(obstacles[0].clearance_m, 0.5 + kRobotRadius_m, 1e-9);
}

TEST(FindObstacles, ExtrapolatesAMovingRobot) {
  const TrackedRobots own = {robot_at({0, 0})};
  const TrackedRobots opponents = {robot_at({1, -0.5}, {0, 2})};
  Obstacles obstacles;
  find_obstacles({own, opponents}, own[0], {2, 0}, obstacles);
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_GT(obstacles[0].position_m.y(), -0.3);
}

// Simulates the drive of a robot: its smallest distance to any robot, and its final distance from
// the target.
struct Drive {
  double nearest_m = 10;
  double left_m = 0;
};
Drive drive(const Vec2& from_m, const Vec2& target_m, const TrackedRobots& others, double seconds) {
  TrackedRobots own = {robot_at(from_m)};
  Drive drive;
  for (int i = 0; i < seconds * 60; ++i) {
    Obstacles obstacles;
    find_obstacles({own, others}, own[0], target_m, obstacles);
    const Vec2 steer_m = steer_for(own[0], target_m, obstacles);
    obey(own[0], drive_via(own[0], steer_m, {target_m, Vec2(1, 0)}, DrivingStyle{}));
    for (const TrackedRobot& other : others) {
      const double gap_m = (other.position_m - own[0].position_m).norm();
      drive.nearest_m = std::min(drive.nearest_m, gap_m);
    }
  }
  drive.left_m = (target_m - own[0].position_m).norm();
  return drive;
}

TEST(Schedule, LeadsPastTwoRobotsBesideEachOther) {
  const TrackedRobots pair = {robot_at({1, 0.1}), numbered(1, robot_at({1, -0.1}))};
  const Drive result = drive({0, 0}, {2, 0}, pair, 4);
  EXPECT_GT(result.nearest_m, kTouching_m);
  EXPECT_LT(result.left_m, 10_mm);
}

// Five robots at random positions, at least 0.6 m apart.
TrackedRobots five_robots(RandomStream& random) {
  TrackedRobots robots;
  while (robots.size() < 5) {
    const double x = -1.4 + 2.8 * random.uniform();
    const double y = -1 + 2 * random.uniform();
    const bool has_room = std::all_of(robots.begin(), robots.end(), [&](const auto& other) {
      return (other.position_m - Vec2(x, y)).norm() > 0.6;
    });
    const int number = static_cast<int>(robots.size());
    if (has_room) robots.push_back(numbered(number, robot_at({x, y})));
  }
  return robots;
}

// The robots are so far apart that there is a path between any two of them.
TEST(Schedule, ArrivesWithoutTouchingStationaryRobots) {
  RandomStream random(2);
  for (int run = 0; run < 200; ++run) {
    const Vec2 target_m(2, 2 * random.uniform() - 1);
    const Drive result = drive({-2, 0}, target_m, five_robots(random), 6);
    ASSERT_GT(result.nearest_m, kTouching_m - 2_mm) << "run " << run;
    ASSERT_LT(result.left_m, 10_mm) << "run " << run;
  }
}

}  // namespace
}  // namespace autoref::strategies
