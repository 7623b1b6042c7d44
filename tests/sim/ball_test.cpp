#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

// A field so large that the ball never reaches a wall.
struct WideScene {
  WideScene() : world(wide(), quiet(), specs(1, 1), 1) {}
  static Field wide() {
    Field field;
    field.length_m = 30.0;
    return field;
  }
  const BallState& ball() const { return world.state().ball; }
  double path_m() const { return ball().position_m.x() + 14.0; }  // from where `kicked` puts it
  void frames(int count) {
    for (int f = 0; f < count; ++f) world.step({}, std::nullopt);
  }
  // Steps until the ball rolls, for at most 30 s. Returns how far it has slid.
  double slid_m() {
    for (int f = 0; f < 60 * 30 && !ball().is_rolling; ++f) world.step({}, std::nullopt);
    return path_m();
  }
  // Steps while the ball is faster than that. Returns its path up to the last such frame.
  double path_above_m(double speed_mps) {
    double last_m = 0.0;
    while (ball().velocity_mps.x() > speed_mps) {
      last_m = path_m();
      world.step({}, std::nullopt);
    }
    return last_m;
  }
  // The ball's greatest height after each of the next frames.
  double highest_m(int count) {
    double highest_m = 0.0;
    for (int f = 0; f < count; ++f) {
      world.step({}, std::nullopt);
      highest_m = std::max(highest_m, ball().height_m);
    }
    return highest_m;
  }

  World world;
};

BallState kicked(double speed_mps, double vertical_mps = 0.0) {
  BallState ball;
  ball.position_m = {-14.0, 1.0};
  ball.velocity_mps = {speed_mps, 0.0};
  ball.vertical_mps = vertical_mps;
  ball.is_rolling = false;
  return ball;
}

class KickedBall : public testing::TestWithParam<double> {};

TEST_P(KickedBall, SlidesThenRollsAsFarAsTheClosedFormsPredict) {
  WideScene scene;
  const double v = GetParam();
  const double rolls_at = 0.67 * v;
  const double slide_m = (v * v - rolls_at * rolls_at) / (2 * 3.4);
  const double roll_m = rolls_at * rolls_at / (2 * 0.30);
  scene.world.put_ball(kicked(v));
  const double slid_m = scene.slid_m();
  scene.frames(60 * 30);
  EXPECT_NEAR(slid_m, slide_m, 0.02 * slide_m + v / 60);  // observed once per frame
  EXPECT_NEAR(scene.path_m(), slide_m + roll_m, 0.01 * (slide_m + roll_m));
  EXPECT_EQ(scene.ball().velocity_mps, Vec2(0, 0));
}

INSTANTIATE_TEST_SUITE_P(AtSeveralSpeeds, KickedBall, testing::Values(1.0, 2.0, 4.0, 5.0));

TEST(RollingBall, LosesThirtyCentimetresPerSecondEachSecond) {
  Scene scene;
  scene.put_ball({-2, 1}, {1.0, 0.0}, true);
  scene.frames(60);
  EXPECT_NEAR(scene.ball().velocity_mps.x(), 0.7, 0.003);
  EXPECT_TRUE(scene.ball().is_rolling);
}

TEST(SlowBall, ComesToRestBelowTenMillimetresPerSecond) {
  Scene scene;
  scene.put_ball({0, 0}, {0.0099, 0.0}, true);
  scene.frame();
  EXPECT_EQ(scene.ball().velocity_mps, Vec2(0, 0));
}

TEST(ChippedBall, FirstLandsAfterTheSquareOfItsSpeedOverGravity) {
  WideScene scene;
  const double v = 5.0;
  scene.world.put_ball(kicked(v / std::sqrt(2.0), v / std::sqrt(2.0)));
  EXPECT_NEAR(scene.path_above_m(3.5), v * v / 9.81, 3.5 / 60 + 0.02);  // the landing slows it
  EXPECT_NEAR(scene.ball().velocity_mps.x(), 0.75 * v / std::sqrt(2.0), 1e-3);
}

TEST(ChippedBall, RisesBallisticallyAndBouncesHalfAsFast) {
  WideScene scene;
  scene.world.put_ball(kicked(2.0, 3.0));
  const double peak_m = scene.highest_m(36);  // lands after 0.61 s = 36.7 frames
  const double second_peak_m = scene.highest_m(60 - 36);
  EXPECT_NEAR(peak_m, 3.0 * 3.0 / (2 * 9.81), 0.005);
  EXPECT_NEAR(second_peak_m, 1.5 * 1.5 / (2 * 9.81), 0.005);
}

TEST(ChippedBall, RollsOnceABounceWouldStayBelowTenMillimetres) {
  WideScene scene;
  // Lands at 0.88 m/s and would bounce at 0.44 m/s, 9.9 mm high.
  scene.world.put_ball(kicked(1.0, 0.88));
  scene.frames(13);
  EXPECT_EQ(scene.ball().height_m, 0.0);
  EXPECT_TRUE(scene.ball().is_rolling);
}

TEST(ChippedBall, FliesOverARobotWithoutTouchingIt) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  BallState ball;
  ball.position_m = {-1.0, 0.0};
  ball.velocity_mps = {3.5, 0.0};
  ball.vertical_mps = 3.5;
  scene.world.put_ball(ball);
  scene.frames(25);
  EXPECT_GT(scene.ball().position_m.x(), 0.3);
  EXPECT_NEAR(scene.ball().position_m.y(), 0.0, 1e-6);
  EXPECT_TRUE(scene.world.touches().empty());
}

TEST(ChippedBall, IsStoppedByARobotItDoesNotClear) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0}, {-1, 0});
  BallState ball;
  ball.position_m = {-0.2, 0.0};
  ball.velocity_mps = {2.0, 0.0};
  ball.vertical_mps = 1.0;  // rises to only 51 mm
  scene.world.put_ball(ball);
  scene.frames(30);
  EXPECT_LT(scene.ball().position_m.x(), -0.09);
}

class BallFallingOnARobot : public testing::TestWithParam<int> {};  // mm beside the robot's centre

TEST_P(BallFallingOnARobot, DoesNotStayThere) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  BallState ball;
  ball.position_m = {0.0, GetParam() / 1000.0};
  ball.height_m = 0.5;
  scene.world.put_ball(ball);
  scene.frames(120);
  EXPECT_EQ(scene.ball().height_m, 0.0);
  EXPECT_GT(distance_to_hull(scene.ball().position_m, scene.robot(kWest0).position_m,
                             scene.robot(kWest0).heading),
            kBallRadius_m - 0.002);
}

INSTANTIATE_TEST_SUITE_P(Beside, BallFallingOnARobot, testing::Values(0, 30, -60, 80),
                         name_of_number);

TEST(FallingBall, RollsOffTheRoofOfAGoalBehindIt) {
  Scene scene;
  BallState ball;
  ball.position_m = {scene.field.half_length_m() + 0.1, 0.1};
  ball.height_m = 0.5;
  scene.world.put_ball(ball);
  scene.frames(180);
  EXPECT_EQ(scene.ball().height_m, 0.0);
  EXPECT_GT(scene.ball().position_m.x(), scene.field.half_length_m() + 0.2);
}

TEST(BallAgainstAWall, KeepsLessThanAThirdOfItsSpeed) {
  Scene scene;
  scene.put_ball({0, scene.field.wall_y_m() - 0.1}, {0.0, 2.0});
  scene.frames(6);
  EXPECT_LT(scene.ball().velocity_mps.y(), 0.0);
  EXPECT_GT(scene.ball().velocity_mps.y(), -0.3 * 2.0);
}

TEST(BallAgainstAWall, MeetsItWhereTheFieldHasItBehindTheGoalLines) {
  Field field;
  field.run_off_m = 0.3;
  field.goal_line_run_off_m = 0.6;
  World world(field, quiet(), specs(1, 1), 1);
  BallState ball;
  ball.position_m = {field.half_length_m() + 0.3, 1.5};
  ball.velocity_mps = {2.0, 0.0};
  world.put_ball(ball);
  double farthest_m = 0;
  for (int i = 0; i < 60; ++i) {
    world.step({}, std::nullopt);
    farthest_m = std::max(farthest_m, world.state().ball.position_m.x());
  }
  EXPECT_NEAR(farthest_m, field.half_length_m() + 0.6 - kBallRadius_m, 0.02);
}

}  // namespace
}  // namespace autoref::sim
