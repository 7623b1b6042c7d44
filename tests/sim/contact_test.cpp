#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "soccer/random.hpp"
#include "soccer/trigonometry.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

double gap_to_hull_m(const Scene& scene, RobotId id) {
  const RobotState& robot = scene.robot(id);
  return distance_to_hull(scene.ball().position_m, robot.position_m, robot.heading) - kBallRadius_m;
}

class FrontPlate : public testing::TestWithParam<int> {};  // mm beside its centre

TEST_P(FrontPlate, IsFlatWithinOneMillimetre) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  scene.put_ball({0.0975, GetParam() / 1000.0}, {-0.04, 0.0}, true);
  const double nearest_m = scene.least_over(60, [&] { return scene.ball().position_m.x(); });
  EXPECT_NEAR(nearest_m, kFrontDistance_m + kBallRadius_m, 0.0009);
}

INSTANTIATE_TEST_SUITE_P(At, FrontPlate, testing::Values(-45, -20, 0, 30, 48), name_of_number);

TEST(PushedBall, LiesAtThePlateWithinOneMillimetre) {
  Scene scene;
  scene.put_robot(kWest0, {-1, 0});
  scene.put_ball_at_plate(kWest0);
  scene.command(kWest0).velocity_mps = {0.5, 0};
  scene.frames(90);
  EXPECT_NEAR(gap_to_hull_m(scene, kWest0), 0.0, 0.001);
}

class RobotsBack : public testing::TestWithParam<int> {};  // angle in degrees

TEST_P(RobotsBack, IsRound) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  const Vec2 from = heading_of(GetParam() * kPi / 180.0);
  scene.put_ball(from * 0.1125, from * -0.04, true);
  const double nearest_m = scene.least_over(60, [&] { return scene.ball().position_m.norm(); });
  EXPECT_NEAR(nearest_m, kRobotRadius_m + kBallRadius_m, 0.0009);
}

INSTANTIATE_TEST_SUITE_P(AtDegrees, RobotsBack, testing::Values(40, 90, 135, 180, -60),
                         name_of_number);

TEST(RobotsBody, ReflectsAboutHalfOfTheSpeed) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0}, {-1, 0});
  scene.put_ball({0.2, 0.0}, {-4.0, 0.0});
  scene.frames(2);
  EXPECT_GT(scene.ball().velocity_mps.x(), 0.4 * 4.0);
  EXPECT_LT(scene.ball().velocity_mps.x(), 0.6 * 4.0);
}

TEST(SlowBallAgainstABody, StillBounces) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0}, {-1, 0});
  scene.put_ball({0.1125, 0.0}, {-0.09, 0.0});  // below Box2D's default threshold of 0.1 m/s
  EXPECT_GT(scene.most_over(6, [&] { return scene.ball().velocity_mps.x(); }), 0.01);
}

class HardKicks : public testing::TestWithParam<int> {};  // sub-steps

TEST_P(HardKicks, NeverPassThroughARobot) {
  RandomStream random(5);
  Configuration configuration = quiet();
  configuration.substeps = GetParam();
  for (int i = 0; i < 600; ++i) {
    Scene scene(configuration);
    const double angle_rad = random.uniform() * 2 * kPi;
    const double robot_rad = random.uniform() * 2 * kPi;
    const double off_m = (random.uniform() - 0.5) * 0.16;
    const Vec2 direction = heading_of(angle_rad);
    const Vec2 robot_heading = heading_of(robot_rad);
    scene.put_robot(kWest0, {0, 0}, robot_heading);
    scene.put_ball(-0.5 * direction + off_m * left_of(direction), 8.0 * direction);
    double deepest_m = 1.0;
    for (int f = 0; f < 6; ++f) {
      scene.frame();
      deepest_m = std::min(deepest_m, gap_to_hull_m(scene, kWest0));
    }
    ASSERT_GT(deepest_m, -0.01) << i;
    // The robot blocks the ball's path; a ball that tunnelled through it would be far behind the
    // robot.
    const double hits_m = distance_to_hull(off_m * left_of(direction), {0, 0}, robot_heading);
    if (hits_m < -0.01) {
      ASSERT_LT(scene.ball().position_m.dot(direction), 0.25) << i;
    }
  }
}

TEST_P(HardKicks, NeverLeaveTheWalls) {
  RandomStream random(6);
  Configuration configuration = quiet();
  configuration.substeps = GetParam();
  Scene scene(configuration);
  for (int i = 0; i < 500; ++i) {
    const Vec2 direction = heading_of(random.uniform() * 2 * kPi);
    const double x = (random.uniform() - 0.5) * 6;
    const double y = (random.uniform() - 0.5) * 4;
    scene.put_ball({x, y}, 8.0 * direction);
    for (int f = 0; f < 90; ++f) {
      scene.frame();
      const Vec2& at = scene.ball().position_m;
      ASSERT_LT(std::abs(at.x()), scene.field.wall_x_m() - kBallRadius_m + 0.002) << i;
      ASSERT_LT(std::abs(at.y()), scene.field.wall_y_m() - kBallRadius_m + 0.002) << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Substeps, HardKicks, testing::Values(1, 2, 4));

TEST(HighBalls, NeverLeaveTheWalls) {
  Scene scene;
  BallState ball;
  ball.position_m = {0, 1.5};
  ball.velocity_mps = {2.0, 4.0};
  ball.vertical_mps = 4.0;
  scene.world.put_ball(ball);
  EXPECT_LT(scene.most_over(240, [&] { return scene.ball().position_m.y(); }),
            scene.field.wall_y_m() - kBallRadius_m + 0.002);
}

TEST(BallInTheGoal, StaysThere) {
  RandomStream random(7);
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    scene.put_robot(kEast0, {0, 1.5});
    const double speed_mps = 2.0 + 6.0 * random.uniform();
    const double y = (random.uniform() - 0.5) * 0.5;
    const double to_y = (random.uniform() - 0.5) * 0.5;
    const Vec2 from(2.0, y);
    const Vec2 to(scene.field.half_length_m() + 0.18, to_y);
    scene.put_ball(from, speed_mps * (to - from).normalized());
    scene.frames(240);
    EXPECT_GT(scene.ball().position_m.x(), scene.field.half_length_m()) << i;
    EXPECT_LT(scene.ball().position_m.x(), scene.field.half_length_m() + scene.field.goal_depth_m);
  }
}

TEST(BallUnderTheBar, IsKeptInTheGoalByTheNet) {
  Scene scene;
  BallState ball;
  ball.position_m = {scene.field.half_length_m() - 0.1, 0.0};
  ball.velocity_mps = {3.0, 0.0};
  ball.height_m = 0.03;
  ball.vertical_mps = 2.0;  // under the bar at the line, above it at the back wall
  scene.world.put_ball(ball);
  scene.frames(180);
  EXPECT_GT(scene.ball().position_m.x(), scene.field.half_length_m());
  EXPECT_LT(scene.ball().position_m.x(), scene.field.half_length_m() + 0.18);
  EXPECT_EQ(scene.ball().height_m, 0.0);
}

TEST(BallOverTheBar, FliesOverTheGoal) {
  Scene scene;
  BallState ball;
  ball.position_m = {scene.field.half_length_m() - 0.1, 0.0};
  ball.velocity_mps = {3.0, 0.0};
  ball.height_m = 0.16;
  ball.vertical_mps = 1.5;
  scene.world.put_ball(ball);
  scene.frames(180);
  EXPECT_GT(scene.ball().position_m.x(), scene.field.half_length_m() + 0.2);
}

// Where a ball is half a second after a hard kick at the inner edge of a post (1: north, -1:
// south).
double ball_after_post_m(double side) {
  Scene scene;
  const double post_y = side * (scene.field.half_goal_m() + 0.01);
  scene.put_ball({2.5, post_y}, {8.0, 0.0});
  scene.frames(30);
  return scene.ball().position_m.x();
}

TEST(GoalPost, StopsABall) {
  EXPECT_LT(ball_after_post_m(-1), Field{}.half_length_m());
  EXPECT_LT(ball_after_post_m(1), Field{}.half_length_m());
}

// A position where a robot can press a ball against a wall, and the direction of pressing.
struct PressedWall {
  const char* name;
  Vec2 ball_m;
  Vec2 to;
};

std::vector<PressedWall> pressed_walls() {
  const Field field;
  const double line = field.half_length_m();
  return {
      {"GoalsSideFromInside", {line + 0.09, field.half_goal_m() - 0.03}, {0, 1}},
      {"GoalsSideFromOutside", {line + 0.09, field.half_goal_m() + 0.05}, {0, -1}},
      {"GoalsBackFromInside", {line + 0.15, 0.1}, {1, 0}},
      {"GoalsBackFromBehind", {line + 0.24, 0.1}, {-1, 0}},
      {"NorthWall", {0.5, field.wall_y_m() - 0.03}, {0, 1}},
      {"EastWall", {field.wall_x_m() - 0.03, 1.2}, {1, 0}},
  };
}

class RobotThatSqueezesTheBall : public testing::TestWithParam<PressedWall> {};

TEST_P(RobotThatSqueezesTheBall, CannotPressItThroughAWall) {
  const Vec2& ball_m = GetParam().ball_m;
  const Vec2& to = GetParam().to;
  Scene scene;
  scene.put_robot(kWest0, ball_m - 0.3 * to, to);
  scene.put_robot(kEast0, {0, -1});
  scene.put_ball(ball_m);
  scene.command(kWest0).velocity_mps = {3.0, 0.0};
  EXPECT_LT(scene.most_over(240, [&] { return (scene.ball().position_m - ball_m).dot(to); }),
            0.035);
  EXPECT_TRUE(scene.world.is_finite());
}

INSTANTIATE_TEST_SUITE_P(At, RobotThatSqueezesTheBall, testing::ValuesIn(pressed_walls()),
                         [](const auto& test) { return test.param.name; });

TEST(TwoRobotsAtOneBall, KeepItBetweenThem) {
  Scene scene;
  scene.put_robot(kWest0, {-0.3, 0}, {1, 0});
  scene.put_robot(kEast0, {0.3, 0}, {-1, 0});
  scene.put_ball({0, 0});
  scene.command(kWest0).velocity_mps = {3, 0};
  scene.command(kEast0).velocity_mps = {3, 0};
  const auto gap_m = [&] {
    return std::min(gap_to_hull_m(scene, kWest0), gap_to_hull_m(scene, kEast0));
  };
  EXPECT_GT(scene.least_over(120, gap_m), -0.01);
}

TEST(Touches, NameTheRobotAndThePositionWhenTheBallArrives) {
  Scene scene;
  scene.put_robot(kWest0, {0, 1});
  scene.put_robot(kEast0, {0, 0}, {-1, 0});
  scene.put_ball({-0.2, 0.0}, {3.0, 0.0});
  const std::vector<Touch> touches = scene.touches_over(10);
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_EQ(touches[0].robot, kEast0);
  EXPECT_FALSE(touches[0].is_kick);
  EXPECT_NEAR(touches[0].ball_m.x(), -0.0965, 0.03);
}

TEST(Touches, CountAKickOnce) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  scene.put_ball_at_plate(kWest0, 0.005);
  scene.command(kWest0).kick_mps = 3.0;
  scene.frame();
  ASSERT_EQ(scene.world.touches().size(), 1U);
  EXPECT_TRUE(scene.world.touches()[0].is_kick);
  EXPECT_EQ(scene.world.touches()[0].robot, kWest0);
  scene.frame();
  EXPECT_TRUE(scene.world.touches().empty());
}

// The number of touches in each of the next frames.
std::vector<std::size_t> touch_counts(Scene& scene, std::size_t frames) {
  std::vector<std::size_t> counts(frames);
  for (std::size_t& count : counts) count = scene.touches_over(1).size();
  return counts;
}

TEST(Touches, CountABallInContactOncePerFrame) {
  Scene scene;
  scene.put_robot(kWest0, {-1, 0});
  scene.put_ball_at_plate(kWest0);
  scene.command(kWest0).velocity_mps = {1, 0};
  scene.command(kWest0).dribble = true;
  scene.frames(5);
  const std::vector<std::size_t> counts = touch_counts(scene, 10);
  EXPECT_GE(*std::min_element(counts.begin(), counts.end()), 1U);
  EXPECT_LE(*std::max_element(counts.begin(), counts.end()), 2U);  // a second one if it separated
}

TEST(Touches, IgnoreTheCutOffPartOfTheDisc) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  scene.put_ball({0.075 + 0.0215 + 0.005, -0.3}, {0, 2.0});
  EXPECT_EQ(scene.touches_over(20).size(), 0U);
  EXPECT_NEAR(scene.ball().position_m.x(), 0.1015, 1e-4);
}

}  // namespace
}  // namespace autoref::sim
