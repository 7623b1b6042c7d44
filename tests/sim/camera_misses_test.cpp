// Cameras of 2026 that capture at different times, and what they miss near robots and in gaps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soccer/trigonometry.hpp"
#include "tests/sim/camera_scene.hpp"

namespace autoref::sim {
namespace {

CameraPositions cameras_of_division_a(std::uint64_t seed) {
  const VisionParameters vision = vision_of("rc2026-a");
  CameraPositions cameras =
      camera_positions(field_of("2026-a"), vision.cameras, vision.camera_height_m);
  draw_capture_ages(vision, 73.2, seed, {cameras.data(), cameras.size()});
  return cameras;
}

// Published: the phases of two cameras scatter by 3.94 ms, which is the standard deviation of a
// phase that is uniform over a frame of 1/73.2 s.
TEST(FreeRunningCameras, HavePhasesWithTheMeasuredStandardDeviation) {
  constexpr int kGames = 4000;
  double sum2_s2 = 0;
  for (std::uint64_t seed = 1; seed <= kGames; ++seed) {
    const CameraPositions cameras = cameras_of_division_a(seed);
    ASSERT_EQ(std::min(cameras[0].age_s, cameras[1].age_s), 0) << "the frame has the latest time";
    sum2_s2 += std::pow(cameras[0].age_s - cameras[1].age_s, 2);
  }
  EXPECT_NEAR(std::sqrt(sum2_s2 / kGames), 0.00394, 0.0001);
}

// The camera above the half of the field with x < 0, in a game in which its captures are old.
struct LateCamera {
  LateCamera() {
    while (cameras_of_division_a(seed)[0].age_s < 0.004) ++seed;
    vision.cameras_run_freely = true;
    vision.camera_error_m = vision.camera_error_rad = 0;
    age_s = cameras_of_division_a(seed)[0].age_s;
  }
  Camera camera() const { return {vision, field_of("2026-a"), 73.2, seed}; }

  VisionParameters vision = steady("rc2026-a");
  std::uint64_t seed = 1;
  double age_s = 0;
};

TEST(FreeRunningCameras, SeeRobotsWhereTheyWereAtTheCapture) {
  const LateCamera late;
  Camera camera = late.camera();
  WorldState world = world_with_robot_at({-2, 1}, {3, 3});
  RobotState& robot = world.robots[Side::kEast][0];
  robot.velocity_mps = {2, -1};
  robot.angular_velocity_radps = 5;
  Frame frame;
  camera.look(world, frame);
  const RobotObservation& seen = frame.robots[Side::kEast][0];
  EXPECT_LT((seen.position_m - (robot.position_m - late.age_s * robot.velocity_mps)).norm(), 1e-5);
  EXPECT_NEAR(angle_of(seen.heading), -5 * late.age_s, 1e-5);
  robot.position_m.x() = 2;
  camera.look(world, frame);
  EXPECT_LT((frame.robots[Side::kEast][0].position_m - robot.position_m).norm(), 1e-5)
      << "the other camera captures at the frame's time";
}

TEST(FreeRunningCameras, SeeAKickedBallBetweenItsPositionsInTwoFrames) {
  const LateCamera late;
  Camera camera = late.camera();
  WorldState world = world_with_robot_at({3, 3}, {-2, 1});
  Frame frame;
  camera.look(world, frame);
  const Vec2 moved_m(0.06, 0);
  world.ball.position_m += moved_m;
  camera.look(world, frame);
  const Vec2 expected_m = world.ball.position_m - late.age_s * 73.2 * moved_m;
  EXPECT_LT((frame.ball->position_m - expected_m).norm(), 1e-5);
  world.ball.position_m = {-4, 2};
  camera.look(world, frame);
  EXPECT_LT((frame.ball->position_m - world.ball.position_m).norm(), 1e-5) << "placed elsewhere";
}

double ball_missed_at(double from_robot_m) {
  VisionParameters vision = steady("rc2026-b");
  vision.ball_misses_near_robots = 0.2;
  vision.near_robots_m = 0.1;
  Camera camera(vision, field_of("2026-b"), 73.2, 1);
  const WorldState world = world_with_robot_at({1, 1}, {1, 1 + from_robot_m});
  constexpr int kFrames = 40000;
  Frame frame;
  int missed = 0;
  for (int i = 0; i < kFrames; ++i) {
    camera.look(world, frame);
    missed += frame.ball ? 0 : 1;
  }
  return static_cast<double>(missed) / kFrames;
}

// The tolerance is five standard deviations.
TEST(MissesNearRobots, FallExponentiallyWithTheDistanceFromTheHull) {
  EXPECT_NEAR(ball_missed_at(0.09), 0.2, 0.01);
  EXPECT_NEAR(ball_missed_at(0.19), 0.2 / std::exp(1.0), 0.0065);
  EXPECT_LT(ball_missed_at(1.09), 0.0005);
}

// Published: whole robots were missing in 1.2 % of frames, in 0.7 % for a single frame.
TEST(RobotGaps, AddTheMeasuredFramesToTheSingleOnes) {
  VisionParameters vision = steady("rc2026-b");
  vision.robot_misses = vision_of("rc2026-b").robot_misses;
  vision.robot_gaps = vision_of("rc2026-b").robot_gaps;
  Camera camera(vision, field_of("2026-b"), 73.2, 1);
  const WorldState world = world_with_robot_at({1, 1}, {3, 3});
  constexpr int kFrames = 400000;
  Frame frame;
  int missed = 0;
  int single = 0;
  int length = 0;
  for (int i = 0; i < kFrames; ++i) {
    camera.look(world, frame);
    const bool is_missed = frame.robots[Side::kEast].empty();
    missed += is_missed ? 1 : 0;
    single += !is_missed && length == 1 ? 1 : 0;
    length = is_missed ? length + 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(missed) / kFrames, 0.012, 0.001);
  EXPECT_NEAR(static_cast<double>(single) / kFrames, 0.007, 0.001);
}

}  // namespace
}  // namespace autoref::sim
