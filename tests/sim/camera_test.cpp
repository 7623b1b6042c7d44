#include "sim/camera.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "sim/presets.hpp"
#include "soccer/robot_shape.hpp"
#include "soccer/trigonometry.hpp"
#include "tests/sim/camera_scene.hpp"

namespace autoref::sim {
namespace {

bool is_float_mm(double metres) {
  // volatile prevents the compiler from skipping the rounding.
  volatile float millimetres = static_cast<float>(metres * 1000.0);
  return static_cast<double>(millimetres) / 1000.0 == metres;
}

TEST(Camera, ReportsPositionsRoundedToFloatMillimetres) {
  Camera camera = camera_of("paper");
  RandomStream random(1);
  WorldState world = world_with_robot_at({0, 0}, {0, 0});
  Frame frame;
  for (int i = 0; i < 1000; ++i) {
    RobotState& robot = world.robots[Side::kEast][0];
    robot.position_m.x() = 6 * random.uniform() - 3;
    robot.position_m.y() = 4 * random.uniform() - 2;
    world.ball.position_m.x() = 6 * random.uniform() - 3;
    world.ball.position_m.y() = 4 * random.uniform() - 2;
    world.ball.height_m = random.uniform();
    camera.look(world, frame);
    const Vec2& seen_m = frame.robots[Side::kEast][0].position_m;
    ASSERT_TRUE(is_float_mm(seen_m.x()) && is_float_mm(seen_m.y())) << i;
    ASSERT_LT((seen_m - robot.position_m).norm(), 1e-6);
    ASSERT_TRUE(is_float_mm(frame.ball->position_m.x()) && is_float_mm(frame.ball->position_m.y()));
    ASSERT_TRUE(is_float_mm(*frame.ball->height_m));
  }
}

TEST(Camera, StampsFramesWithNumberDividedByRate) {
  Camera camera = camera_of("paper");
  WorldState world;
  world.frame = 90;
  Frame frame;
  camera.look(world, frame);
  EXPECT_EQ(frame.number, 90);
  EXPECT_EQ(frame.time_s, 1.5);
}

TEST(Camera, ReportsAFlyingBallOnTheRayThroughIt) {
  Camera camera = camera_of("none");
  WorldState world;
  world.ball.position_m = {1, 0.5};
  world.ball.height_m = 0.6;
  Frame frame;
  camera.look(world, frame);
  ASSERT_TRUE(frame.ball);
  EXPECT_EQ(frame.ball->height_m, std::nullopt);
  const CameraPosition& from = frame.ball->seen_from;
  EXPECT_EQ(from.position_m, Vec2(Field{}.half_length_m() / 2, Field{}.half_width_m() / 2));
  // Three collinear points: the camera, the ball's centre, and the reported position at the height
  // of the centre of a ball on the carpet.
  const double share = 0.6 / (from.height_m - kBallRadius_m);
  const Vec2 ball_m = frame.ball->position_m + share * (from.position_m - frame.ball->position_m);
  EXPECT_LT((ball_m - world.ball.position_m).norm(), 1e-6);
}

TEST(Camera, HidesABallOnlyBehindARobot) {
  const CameraPosition camera{{0, 0}, 4};
  RobotState robot;
  robot.position_m = {2, 0};
  robot.heading = {0, 1};
  // Across the hull the ray to a ball on the carpet rises by 125.5 mm. The hull begins 90 mm behind
  // the robot's centre, and the shadow ends where the ray meets the far edge at robot height.
  const double end_m = 2.09 + 2.09 * (kRobotHeight_m - kBallRadius_m) / (4 - kRobotHeight_m);
  EXPECT_TRUE(hides_ball(robot, {end_m - 0.001, 0}, 0, camera));
  EXPECT_FALSE(hides_ball(robot, {end_m + 0.001, 0}, 0, camera));
  EXPECT_FALSE(hides_ball(robot, {1.85, 0}, 0, camera)) << "in front of the robot";
  EXPECT_FALSE(hides_ball(robot, {2.1, 0.12}, 0, camera)) << "beside it";
  EXPECT_FALSE(hides_ball(robot, {end_m - 0.001, 0}, 0.02, camera)) << "too high for the shadow";
  robot.heading = {1, 0};  // the flat front is 15 mm nearer to the camera than the round back
  EXPECT_FALSE(hides_ball(robot, {end_m - 0.001, 0}, 0, camera));
  EXPECT_TRUE(hides_ball(robot, {end_m - 0.017, 0}, 0, camera));
}

// Samples the ray in small steps, independently of the camera's geometry.
bool is_hidden_step_by_step(const RobotState& robot, const Vec2& ball_m, double height_m,
                            const CameraPosition& camera) {
  constexpr int kSteps = 4000;
  const double middle_m = height_m + kBallRadius_m;
  for (int i = 0; i <= kSteps; ++i) {
    const double share = 0.2 * i / kSteps;
    const double z_m = middle_m + (camera.height_m - middle_m) * share;
    const Vec2 at_m = ball_m + (camera.position_m - ball_m) * share;
    if (z_m < kRobotHeight_m && distance_to_hull(at_m, robot.position_m, robot.heading) <= 0.0) {
      return true;
    }
  }
  return false;
}

TEST(Camera, HidesTheBallWhileTheRayPassesThroughARobot) {
  RandomStream random(3);
  int hidden = 0;
  int doubtful = 0;
  for (int i = 0; i < 3000; ++i) {
    RobotState robot;
    robot.heading = heading_of(2 * kPi * random.uniform());
    const double camera_angle_rad = 2 * kPi * random.uniform();
    const CameraPosition camera{heading_of(camera_angle_rad) * (3 * random.uniform()), 4};
    const double ball_angle_rad = camera_angle_rad + kPi + 2 * (random.uniform() - 0.5);
    const Vec2 ball_m = heading_of(ball_angle_rad) * (0.1 + 0.12 * random.uniform());
    const double height_m = random.uniform() < 0.5 ? 0.0 : 0.1 * random.uniform();
    const bool is_hidden = hides_ball(robot, ball_m, height_m, camera);
    hidden += is_hidden ? 1 : 0;
    // Sampling may just miss a corner of the hull.
    if (is_hidden != is_hidden_step_by_step(robot, ball_m, height_m, camera)) ++doubtful;
  }
  EXPECT_GT(hidden, 300);
  EXPECT_LT(hidden, 2700);
  EXPECT_LE(doubtful, 3);
}

// The number of frames in which the camera sees the ball.
int frames_with_ball(Camera& camera, const WorldState& world, int frames) {
  Frame frame;
  int with_ball = 0;
  for (int i = 0; i < frames; ++i) {
    camera.look(world, frame);
    with_ball += frame.ball ? 1 : 0;
  }
  return with_ball;
}

TEST(Camera, DoesNotSeeAHiddenBallUntilTheRobotLeaves) {
  Camera camera = camera_of("none");
  Configuration configuration;
  apply_camera_preset("none", configuration);
  configuration.vision.robots_hide_ball = true;
  Camera hiding(configuration.vision, Field{}, 60, 1);
  const CameraPosition position = camera_positions(Field{}, 4, 4)[3];
  // Visible only to the camera of its quarter, behind a robot.
  const Vec2 outwards = position.position_m.normalized();
  const Vec2 robot_m = position.position_m + outwards * 1.5;
  WorldState world = world_with_robot_at(robot_m, robot_m + outwards * 0.115);
  world.robots[Side::kEast][0].heading = {0, std::copysign(1.0, outwards.x())};
  EXPECT_EQ(frames_with_ball(camera, world, 1), 1) << "robots are transparent under 'none'";
  EXPECT_EQ(frames_with_ball(hiding, world, 20), 0);
  world.robots[Side::kEast][0].position_m += left_of(outwards) * 0.2;
  EXPECT_EQ(frames_with_ball(hiding, world, 1), 1);
}

// Those of the positions at which the camera does not see the ball.
std::vector<Vec2> unseen_balls_m(Camera& camera, std::vector<Vec2> positions_m) {
  WorldState world;
  Frame frame;
  std::erase_if(positions_m, [&](const Vec2& position_m) {
    world.ball.position_m = position_m;
    camera.look(world, frame);
    return frame.ball.has_value();
  });
  return positions_m;
}

TEST(Camera, CoversEveryPointInsideTheWalls) {
  Camera camera = camera_of("none");
  EXPECT_EQ(unseen_balls_m(camera, grid_within_walls(Field{}, 20)), std::vector<Vec2>{});
}

// What a camera with that seed sees of a ball at rest in 50 frames; nothing where it misses it.
std::vector<std::optional<Vec2>> noisy_balls_m(std::uint64_t seed) {
  Camera camera = camera_of("realistic", seed);
  const WorldState world = world_with_robot_at({1, 1}, {-1, 0.5});
  Frame frame;
  std::vector<std::optional<Vec2>> balls_m(50);
  for (std::optional<Vec2>& ball_m : balls_m) {
    camera.look(world, frame);
    if (frame.ball) ball_m = frame.ball->position_m;
  }
  return balls_m;
}

TEST(Camera, DrawsItsNoiseFromTheSeed) {
  EXPECT_EQ(noisy_balls_m(1), noisy_balls_m(1));
  EXPECT_NE(noisy_balls_m(1), noisy_balls_m(2));
}

}  // namespace
}  // namespace autoref::sim
