#include "sim/placement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "soccer/random.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

TEST(PlacedBall, EndsAtRestOnItsTarget) {
  Scene scene;
  scene.put_ball({2, 1});
  scene.placement = Placement{{-1.5, -0.7}, false};
  scene.frames(240);
  EXPECT_LT((scene.ball().position_m - Vec2(-1.5, -0.7)).norm(), 1e-6);
  EXPECT_EQ(scene.ball().velocity_mps, Vec2(0, 0));
  EXPECT_EQ(scene.ball().height_m, 0.0);
}

// The greatest speed and acceleration of the ball, measured from frame to frame.
struct Motion {
  double speed_mps = 0;
  double acceleration_mps2 = 0;
};

Motion greatest_over(Scene& scene, int frames) {
  Vec2 last_m = scene.ball().position_m;
  Vec2 last_mps = scene.ball().velocity_mps;
  Motion greatest;
  for (int f = 0; f < frames; ++f) {
    scene.frame();
    const Vec2 now_mps = (scene.ball().position_m - last_m) * 60.0;
    greatest.speed_mps = std::max(greatest.speed_mps, now_mps.norm());
    greatest.acceleration_mps2 =
        std::max(greatest.acceleration_mps2, (now_mps - last_mps).norm() * 60.0);
    last_m = scene.ball().position_m;
    last_mps = now_mps;
  }
  return greatest;
}

TEST(PlacedBall, StaysWithinTheLimitsOfSpeedAndAcceleration) {
  Scene scene;
  scene.put_ball({2, 1});
  scene.placement = Placement{{-2.5, -1.5}, false};
  const Motion greatest = greatest_over(scene, 240);
  EXPECT_LE(greatest.acceleration_mps2, 4.0 + 0.05);
  EXPECT_NEAR(greatest.speed_mps, 3.0, 0.01);
}

TEST(PlacedBall, IsFirstStoppedIfItIsMoving) {
  Scene scene;
  scene.put_ball({-2, 1.5}, {6.0, 0.0});
  scene.placement = Placement{{-2, 0.5}, false};
  scene.frames(12);
  EXPECT_NEAR(scene.ball().velocity_mps.x(), 6.0 - 20.0 * 0.2, 0.01);
  EXPECT_NEAR(scene.ball().position_m.y(), 1.5, 1e-6);
  scene.frames(180);
  EXPECT_LT((scene.ball().position_m - Vec2(-2, 0.5)).norm(), 1e-6);
}

TEST(PlacedBall, NeitherPushesNorTouchesARobot) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  scene.put_robot(kEast0, {-1, 0}, {-1, 0});
  scene.put_ball({1, 0});
  scene.placement = Placement{{-1, 0}, false};  // a robot stands on the target
  EXPECT_EQ(scene.touches_over(180).size(), 0U);
  EXPECT_LT((scene.ball().position_m - Vec2(-1, 0)).norm(), 1e-6);
  EXPECT_LT((scene.robot(kWest0).position_m - Vec2(0, 0)).norm(), 1e-6);
  EXPECT_LT((scene.robot(kEast0).position_m - Vec2(-1, 0)).norm(), 1e-6);
}

TEST(BallReleasedInsideARobot, IsPushedOutGently) {
  Scene scene;
  scene.put_robot(kEast0, {-1, 0.03}, {-1, 0});
  scene.placement = Placement{{-1, 0}, true};
  scene.frames(5);
  scene.placement.reset();
  EXPECT_LT(scene.most_over(60, [&] { return scene.ball().velocity_mps.norm(); }), 0.5);
  const RobotState& robot = scene.robot(kEast0);
  EXPECT_GT(distance_to_hull(scene.ball().position_m, robot.position_m, robot.heading),
            kBallRadius_m - 0.001);
}

TEST(BallPlacedAtOnce, IsThereAfterOneFrame) {
  Scene scene;
  scene.put_ball({2, 1}, {5, 0});
  scene.placement = Placement{{-1.5, -0.7}, true};
  scene.frame();
  EXPECT_LT((scene.ball().position_m - Vec2(-1.5, -0.7)).norm(), 1e-6);
  EXPECT_EQ(scene.ball().velocity_mps, Vec2(0, 0));
}

TEST(BallPlacedAtOnce, CanFollowADragThatTookTooLong) {
  Scene scene;
  scene.put_ball({2, 1});
  scene.placement = Placement{{-1.5, -0.7}, false};
  scene.frames(20);
  scene.placement->at_once = true;
  scene.frame();
  EXPECT_LT((scene.ball().position_m - Vec2(-1.5, -0.7)).norm(), 1e-6);
}

// The greatest change of the ball's velocity in a frame, as an acceleration.
double greatest_change_mps2(Scene& scene, int frames) {
  Vec2 last_mps = scene.ball().velocity_mps;
  return scene.most_over(frames, [&] {
    const Vec2 change_mps = scene.ball().velocity_mps - last_mps;
    last_mps = scene.ball().velocity_mps;
    return change_mps.norm() * 60.0;
  });
}

TEST(PlacedBall, ChangesToANewTargetWithoutAJump) {
  Scene scene;
  scene.put_ball({2, 0});
  scene.placement = Placement{{-2, 0}, false};
  scene.frames(60);
  scene.placement = Placement{{1, 1}, false};
  EXPECT_LE(greatest_change_mps2(scene, 180), 20.0 + 4.0);
  EXPECT_LT((scene.ball().position_m - Vec2(1, 1)).norm(), 1e-6);
}

TEST(PlacedBall, CaughtInTheAirSinksToTheCarpet) {
  Scene scene;
  BallState ball;
  ball.velocity_mps = {1, 0};
  ball.height_m = 0.4;
  ball.vertical_mps = 2.0;
  scene.world.put_ball(ball);
  scene.placement = Placement{{1, 0}, false};
  scene.frames(120);
  EXPECT_EQ(scene.ball().height_m, 0.0);
  EXPECT_EQ(scene.ball().vertical_mps, 0.0);
  EXPECT_LT((scene.ball().position_m - Vec2(1, 0)).norm(), 1e-6);
}

TEST(ReleasedBall, IsFreeAgain) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  scene.placement = Placement{{0.0965, 0}, true};
  scene.frames(2);
  scene.placement.reset();
  scene.command(kWest0).kick_mps = 5.0;
  scene.frames(2);
  EXPECT_GT(scene.ball().velocity_mps.x(), 4.5);
}

// Distance of a point from the nearest wall of a goal; 0 inside a wall.
double to_goal_walls_m(const Field& field, const Vec2& p) {
  const double line = field.half_length_m();
  const double back = line + field.goal_depth_m;
  const double y = field.half_goal_m() + field.goal_wall_thickness_m / 2;
  const Vec2 q(std::abs(p.x()), std::abs(p.y()));
  const double side_m = distance_to_segment(q, {line, y}, {back, y});
  const double back_m = distance_to_segment(q, {back + 0.01, 0}, {back + 0.01, y});
  return std::min(side_m, back_m) - field.goal_wall_thickness_m / 2;
}

TEST(PlacedBall, NeverCrossesAGoalsWalls) {
  const Field field;
  RandomStream random(9);
  for (int i = 0; i < 300; ++i) {
    const double x =
        (random.uniform() < 0.5 ? -1 : 1) * (field.half_length_m() - 0.1 + 0.74 * random.uniform());
    const double y = (random.uniform() - 0.5) * 1.4;
    if (to_goal_walls_m(field, {x, y}) < kBallRadius_m) continue;
    const Vec2 target((random.uniform() - 0.5) * 5.8, 0.0);
    Vec2 from(x, y);
    for (const Vec2& corner : route_between(field, {x, y}, target, 0.05)) {
      for (int k = 0; k <= 200; ++k) {
        const Vec2 p = from + (corner - from) * (k / 200.0);
        ASSERT_GT(to_goal_walls_m(field, p), kBallRadius_m - 0.003) << x << " " << y;
      }
      from = corner;
    }
    EXPECT_EQ(from, target);
  }
}

// The ball's y while it is behind the east goal line; -1 while it is on the field.
double y_behind_line_m(const Scene& scene) {
  const Vec2& at_m = scene.ball().position_m;
  return at_m.x() > scene.field.half_length_m() ? at_m.y() : -1;
}

TEST(PlacedBall, LeavesAGoalThroughItsOpening) {
  Scene scene;
  scene.put_ball({scene.field.half_length_m() + 0.15, 0.3});
  scene.placement = Placement{{0, 1.8}, false};
  EXPECT_LT(scene.most_over(300, [&] { return y_behind_line_m(scene); }),
            scene.field.half_goal_m() - 0.02);
  EXPECT_LT((scene.ball().position_m - Vec2(0, 1.8)).norm(), 1e-6);
}

void expect_rotated_route(const Vec2& from_m) {
  const Route route = route_between(Field{}, from_m, {1, 0.5}, 0.05);
  const Route turned = route_between(Field{}, -from_m, {-1, -0.5}, 0.05);
  ASSERT_EQ(route.size(), turned.size()) << from_m.transpose();
  for (std::size_t i = 0; i < route.size(); ++i)
    EXPECT_EQ(route[i], -turned[i]) << from_m.transpose() << ", corner " << i;
}

TEST(PlacedBall, HasRotatedRoutesForRotatedPositions) {
  expect_rotated_route({3.3, 0.0});
  expect_rotated_route({3.3, 0.2});
  expect_rotated_route({3.1, -0.3});
  expect_rotated_route({3.2, 1.0});
}

}  // namespace
}  // namespace autoref::sim
