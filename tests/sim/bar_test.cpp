#include "sim/ball.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/chance.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr double kLine_m = 3.025;  // half of the field's 6.05 m

// A ball whose lowest point is at the given height, just in front of the east goal's centre and
// flying towards it.
BallState flying(double height_m, double vertical_mps = 0.0) {
  BallState ball;
  ball.position_m = {kLine_m - 0.1, 0.0};
  ball.velocity_mps = {6.0, 0.0};
  ball.height_m = height_m;
  ball.vertical_mps = vertical_mps;
  ball.is_rolling = false;
  return ball;
}

BallState after_frames(const BallState& ball, int frames) {
  Scene scene;
  scene.put_robot(kEast0, {0, 1.5});
  scene.world.put_ball(ball);
  scene.frames(frames);
  return scene.ball();
}

// At 6 m/s the ball crosses the line after 17 ms, in which it falls by 1.4 mm. The bar is at 155 to
// 165 mm, the ball is 43 mm high.
TEST(Bar, IsHitByABallWithItsCentreAtBarHeight) {
  const BallState ball = after_frames(flying(0.140), 3);
  EXPECT_NEAR(ball.velocity_mps.x(), -0.3 * 6.0, 0.05);
  EXPECT_LT(ball.position_m.x(), kLine_m);
}

TEST(Bar, IsHitByTheUpperPartOfABall) {
  const BallState ball = after_frames(flying(0.125), 1);
  EXPECT_LT(ball.velocity_mps.x(), 2.0);
  EXPECT_LT(ball.vertical_mps, -1.0);  // deflected downwards
}

TEST(Bar, IsHitByTheLowerPartOfABall) {
  const BallState ball = after_frames(flying(0.160), 1);
  EXPECT_LT(ball.velocity_mps.x(), 4.0);
  EXPECT_GT(ball.vertical_mps, 1.0);  // deflected upwards
}

TEST(Bar, IsPassedBelowAndAbove) {
  EXPECT_EQ(after_frames(flying(0.111), 1).velocity_mps.x(), 6.0);
  EXPECT_EQ(after_frames(flying(0.169), 1).velocity_mps.x(), 6.0);
  EXPECT_GT(after_frames(flying(0.111), 2).position_m.x(), kLine_m + 0.05);
}

bool hits_bar_at(double y_m, double side) {
  BallState former = flying(0.140);
  former.position_m = {side * 2.99, y_m};
  BallState now = former;
  now.position_m.x() = side * 3.02;
  now.velocity_mps.x() = side * 6.0;
  return bounced_off_bar(Field{}, 0.3, former, now).has_value();
}

class BarOfGoal : public testing::TestWithParam<int> {};  // -1: west, 1: east

TEST_P(BarOfGoal, ExtendsFromPostToPost) {
  EXPECT_FALSE(hits_bar_at(-0.36, GetParam()));
  EXPECT_TRUE(hits_bar_at(-0.34, GetParam()));
  EXPECT_TRUE(hits_bar_at(0, GetParam()));
  EXPECT_TRUE(hits_bar_at(0.34, GetParam()));
  EXPECT_FALSE(hits_bar_at(0.36, GetParam()));
}

INSTANTIATE_TEST_SUITE_P(InThe, BarOfGoal, testing::Values(-1, 1),
                         [](const auto& test) { return test.param < 0 ? "West" : "East"; });

TEST(Bar, DoesNotDelayABallThatMovesAway) {
  BallState former = flying(0.140);
  former.position_m.x() = kLine_m - 0.02;
  former.velocity_mps.x() = -1.0;
  BallState now = former;
  now.position_m.x() -= 0.004;
  EXPECT_FALSE(bounced_off_bar(Field{}, 0.3, former, now));
}

double distance_from_bar_m(const BallState& ball) {
  return Vec2(ball.position_m.x() - kLine_m - 0.005, ball.height_m + kBallRadius_m - 0.160).norm();
}

TEST(Bar, IsNeverPassedThrough) {
  RandomStream random(41);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Scene scene;
    scene.put_robot(kEast0, {0, 1.5});
    const double height_m = between(random, 0.1, 0.19);
    const double vertical_mps = between(random, -3, 3);
    BallState ball = flying(height_m, vertical_mps);
    ball.velocity_mps.x() = between(random, 1, 8);
    scene.world.put_ball(ball);
    for (int f = 0; f < 6; ++f) {
      scene.frame();
      ASSERT_GT(distance_from_bar_m(scene.ball()), kBallRadius_m + 0.005 - 0.002) << i;
    }
    hits += scene.ball().velocity_mps.x() < 0.0 ? 1 : 0;
  }
  EXPECT_GT(hits, 200);
}

}  // namespace
}  // namespace autoref::sim
