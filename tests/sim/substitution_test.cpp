// Robots that leave the field and come back.
#include <gtest/gtest.h>

#include <vector>

#include "sim/camera.hpp"
#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

constexpr RobotId kReplaced{Side::kWest, 1};

// A ball rolls along y = 0 towards east's robot; west's robot is out of the way.
Scene ball_at_a_robot() {
  Scene scene;
  scene.put_robot(kWest0, {-2, 1});
  scene.put_robot(kEast0, {1, 0}, {-1, 0});
  scene.put_ball({0.5, 0}, {3, 0});
  return scene;
}

TEST(ARobotOffTheField, DoesNotBlockTheBall) {
  Scene scene = ball_at_a_robot();
  scene.world.take_off(kEast0);
  scene.frames(30);
  EXPECT_GT(scene.ball().position_m.x(), 1.3);
  Scene still_there = ball_at_a_robot();
  still_there.frames(30);
  EXPECT_LT(still_there.ball().position_m.x(), 1.0);
}

TEST(ARobotOffTheField, DoesNotStopABallThatLandsThere) {
  Scene scene = ball_at_a_robot();
  scene.world.take_off(kEast0);
  BallState falling;
  falling.position_m = {1, 0};
  falling.height_m = 0.3;
  scene.world.put_ball(falling);
  EXPECT_LT(scene.least_over(20, [&] { return scene.ball().height_m; }), 0.05);
}

TEST(ARobotOffTheField, IsMissingFromStateAndFrame) {
  Scene scene(quiet(), specs(3, 1));
  scene.world.take_off(kReplaced);
  scene.frame();
  Frame frame;
  Camera({}, scene.field, 60, 1).look(scene.world.state(), frame);
  ASSERT_EQ(scene.world.state().robots[Side::kWest].size(), 2U);
  ASSERT_EQ(frame.robots[Side::kWest].size(), 2U);
  EXPECT_EQ(frame.robots[Side::kWest][1].number, 2);
  EXPECT_FALSE(scene.world.is_on(kReplaced));
}

TEST(ARobotOffTheField, NeitherDrivesNorKicks) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  scene.put_ball_at_plate(kWest0, 0.005);
  scene.world.take_off(kWest0);
  scene.command(kWest0).velocity_mps = {2, 0};
  scene.command(kWest0).kick_mps = 5;
  scene.command(kWest0).dribble = true;
  scene.frames(30);
  EXPECT_LT(scene.ball().velocity_mps.norm(), 0.01);
  EXPECT_TRUE(scene.world.touches().empty());
  scene.put_ball({1, 1});
  scene.world.put_on(kWest0, {0, 0}, {1, 0});
  EXPECT_EQ(scene.robot(kWest0).velocity_mps, Vec2(0, 0));
}

// Where a ball is a second after it rolled towards a robot that has left the field. A robot next to
// the ball would make the world take short steps.
Vec2 ball_past_missing_robot_m(int substeps) {
  Configuration configuration = quiet();
  configuration.substeps = substeps;
  Scene scene(configuration);
  scene.put_robot(kWest0, {-2, 1});
  scene.put_robot(kEast0, {1, 0}, {-1, 0});
  scene.put_ball({0.7, 0}, {0.5, 0}, true);
  scene.world.take_off(kEast0);
  scene.frames(60);
  return scene.ball().position_m;
}

TEST(ARobotOffTheField, DoesNotPreventLongerSteps) {
  EXPECT_EQ(ball_past_missing_robot_m(quiet().substeps), ball_past_missing_robot_m(2));
}

TEST(ARobotOffTheField, CanReturnAndPlay) {
  Scene scene = ball_at_a_robot();
  scene.world.take_off(kEast0);
  scene.frames(60);
  scene.put_ball({0.7, 1.0}, {0, 0}, true);
  EXPECT_FALSE(scene.world.is_free({0.75, 1.0}));
  ASSERT_TRUE(scene.world.is_free({0.9, 1.0}));
  scene.world.put_on(kEast0, {0.9, 1.0}, {-1, 0});
  EXPECT_FALSE(scene.world.is_free({0.9, 1.15}));
  scene.command(kEast0).velocity_mps = {1, 0};
  scene.command(kEast0).kick_mps = 4;
  scene.frames(30);
  EXPECT_LT(scene.robot(kEast0).position_m.x(), 0.85);
  EXPECT_LT(scene.ball().velocity_mps.x(), -1.0);
}

// Where robot 1, with noisy motors, is after a second, with or without robot 0.
Vec2 driven_by_second_m(bool first_leaves) {
  Scene scene(quiet(), specs(2, 0, RobotSpec{}), 7);
  scene.put_robot(kWest0, {-2, 1.5});
  scene.put_robot(kReplaced, {-2, -1.5});
  scene.put_ball({2, 0});
  if (first_leaves) scene.world.take_off(kWest0);
  scene.command(kWest0).velocity_mps = scene.command(kReplaced).velocity_mps = {1, 0};
  scene.frames(60);
  return scene.world.state().robots[Side::kWest].back().position_m;
}

TEST(ARobotOffTheField, DoesNotShiftItsTeammatesRandomNumbers) {
  EXPECT_EQ(driven_by_second_m(true), driven_by_second_m(false));
}

// A crowd at the ball, with a robot leaving and returning.
std::vector<Vec2> trajectories_with_changes() {
  Scene scene(quiet(), specs(3, 3, RobotSpec{}), 5);
  std::vector<Vec2> trajectory_m;
  for (int f = 0; f < 600; ++f) {
    for (const Side side : kSides) {
      for (const RobotState& robot : scene.world.state().robots[side]) {
        RobotCommand& command = scene.command({side, robot.number});
        command.velocity_mps = to_local(scene.ball().position_m - robot.position_m, robot.heading);
        command.kick_mps = 2;
      }
    }
    if (f == 100) scene.world.take_off(kReplaced);
    if (f == 300 && scene.world.is_free({-1, 2.2}))
      scene.world.put_on(kReplaced, {-1, 2.2}, {1, 0});
    scene.frame();
    trajectory_m.push_back(scene.ball().position_m);
  }
  EXPECT_TRUE(scene.world.is_on(kReplaced));
  return trajectory_m;
}

TEST(RobotsThatComeAndGo, KeepTheGameReproducible) {
  EXPECT_EQ(trajectories_with_changes(), trajectories_with_changes());
}

}  // namespace
}  // namespace autoref::sim
