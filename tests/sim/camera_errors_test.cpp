// What distinguishes the cameras of 2026: few of them, which disagree, and false detections.
#include "sim/camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soccer/trigonometry.hpp"
#include "tests/sim/camera_scene.hpp"

namespace autoref::sim {
namespace {

TEST(CameraPositions, OfTheDivisionsIn2026) {
  const VisionParameters b = vision_of("rc2026-b");
  const auto one = camera_positions(field_of("2026-b"), b.cameras, b.camera_height_m);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0].position_m, Vec2(0, 0));
  const VisionParameters a = vision_of("rc2026-a");
  const auto two = camera_positions(field_of("2026-a"), a.cameras, a.camera_height_m);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].position_m, Vec2(-3, 0));
  EXPECT_EQ(two[1].position_m, Vec2(3, 0));
  const auto [least_m, most_m] = std::minmax({one[0].height_m, two[0].height_m, two[1].height_m});
  EXPECT_GE(least_m, 6.0);
  EXPECT_LE(most_m, 6.5);
}

void expect_good_view_everywhere(const char* preset, const char* book) {
  const Field field = field_of(book);
  Camera camera(steady(preset), field, 73.2, 1);
  WorldState world;
  Frame frame;
  for (const Vec2& ball_m : grid_within_walls(field, 10)) {
    world.ball.position_m = ball_m;
    camera.look(world, frame);
    ASSERT_TRUE(frame.ball) << preset << ball_m.transpose();
    ASSERT_FALSE(frame.ball->height_m);
    ASSERT_LT((frame.ball->position_m - ball_m).norm(), 0.025) << preset << ball_m.transpose();
  }
}

TEST(CameraPositions, CoverEveryPointInsideTheWallsAndReportNoHeight) {
  expect_good_view_everywhere("rc2026-b", "2026-b");
  expect_good_view_everywhere("rc2026-a", "2026-a");
}

// The root mean squares of the disagreement of two cameras, over games and over the field. The
// points cover whole periods of the errors, so the means are exact.
struct Disagreement {
  double position_m = 0;
  double heading_rad = 0;
};

Disagreement disagreement_of_two_cameras() {
  constexpr int kGames = 50;
  double sum_m2 = 0;
  double sum_rad2 = 0;
  int points = 0;
  for (int seed = 0; seed < kGames; ++seed) {
    RandomStream chance(seed);
    const CameraErrors errors(vision_of("rc2026-a"), field_of("2026-a"), chance);
    for (int i = 0; i < 24; ++i) {
      for (int j = 0; j < 18; ++j) {
        const Vec2 at_m(-5.75 + 0.5 * i, -4.25 + 0.5 * j);
        sum_m2 += (errors.position_m(0, at_m) - errors.position_m(1, at_m)).squaredNorm();
        sum_rad2 += std::pow(errors.heading_rad(0, at_m) - errors.heading_rad(1, at_m), 2);
        ++points;
      }
    }
  }
  return {std::sqrt(sum_m2 / points), std::sqrt(sum_rad2 / points)};
}

TEST(CameraErrors, MakeTwoCamerasDisagreeBy20MillimetresAnd29Milliradians) {
  const Disagreement disagreement = disagreement_of_two_cameras();
  EXPECT_NEAR(disagreement.position_m, 0.020, 1e-6);
  EXPECT_NEAR(disagreement.heading_rad, 0.029, 1e-6);
}

// The greatest change of the error along the field's length, in steps of 0.1 m.
double greatest_change_m(const CameraErrors& errors) {
  double greatest_m = 0;
  for (int i = 0; i < 120; ++i) {
    const Vec2 at_m(-6 + 0.1 * i, 0.3);
    const Vec2 step_m = errors.position_m(0, at_m + Vec2(0.1, 0)) - errors.position_m(0, at_m);
    greatest_m = std::max(greatest_m, step_m.norm());
  }
  return greatest_m;
}

TEST(CameraErrors, AreSmooth) {
  RandomStream chance(3);
  const CameraErrors errors(vision_of("rc2026-a"), field_of("2026-a"), chance);
  EXPECT_LT(greatest_change_m(errors), 0.001);  // at most 10 mm * 2 pi / 12 m * 0.1 m = 0.5 mm
}

TEST(CameraErrors, MakeARobotJumpAtTheSeam) {
  Camera camera(steady("rc2026-a"), field_of("2026-a"), 73.2, 5);
  Frame frame;
  const auto error_at_m = [&](const Vec2& at_m) -> Vec2 {
    camera.look(world_with_robot_at(at_m, {3, 3}), frame);
    return frame.robots[Side::kEast][0].position_m - at_m;
  };
  const Vec2 before_m = error_at_m({-0.001, 1});
  const Vec2 after_m = error_at_m({0.001, 1});
  EXPECT_LT((before_m + after_m).norm(), 1e-4) << "neighbours have opposite errors";
  EXPECT_GT((before_m - after_m).norm(), 0.002);
  EXPECT_LT((before_m - after_m).norm(), 0.050);
}

double ball_seen_m(std::uint64_t seed) {
  Camera camera(steady("rc2026-a"), field_of("2026-a"), 73.2, seed);
  Frame frame;
  camera.look(world_with_robot_at({1, 1}, {3, 3}), frame);
  return frame.ball->position_m.x();
}

TEST(CameraErrors, AreThoseOfTheGamesSeed) {
  EXPECT_EQ(ball_seen_m(1), ball_seen_m(1));
  EXPECT_EQ(ball_seen_m(2), ball_seen_m(2));
  EXPECT_NE(ball_seen_m(1), ball_seen_m(2));
}

// Twelve robots at rest, and a ball that is far from all of them.
WorldState full_world() {
  WorldState world;
  for (const Side side : kSides) {
    for (int number = 0; number < 6; ++number) {
      RobotState robot;
      robot.number = 2 * number;
      robot.position_m = {goal_sign(side) * (0.5 + 0.6 * number), -2.0 + 0.5 * number};
      robot.heading = heading_of(0.7 * number);
      world.robots[side].push_back(robot);
    }
  }
  world.ball.position_m = {0, 2.8};
  return world;
}

// How far the point is ahead of the robot nearest to it; 0 if it is not straight ahead.
double ahead_of_a_robot_m(const WorldState& world, const Vec2& point_m) {
  Vec2 nearest_m{9, 9};
  Vec2 heading{1, 0};
  for (const Side side : kSides) {
    for (const RobotState& robot : world.robots[side]) {
      const Vec2 from_m = point_m - robot.position_m;
      if (from_m.norm() >= nearest_m.norm()) continue;
      nearest_m = from_m;
      heading = robot.heading;
    }
  }
  return std::abs(nearest_m.dot(left_of(heading))) < 1e-6 ? nearest_m.dot(heading) : 0;
}

TEST(FalseBalls, AppearAtTheirRateAheadOfRobots) {
  VisionParameters vision = steady("rc2026-b");
  vision.false_balls_per_s = 0.06;
  constexpr int kFrames = 200000;
  Camera camera(vision, field_of("2026-b"), 73.2, 1);
  const WorldState world = full_world();
  Frame frame;
  int count = 0;
  for (int i = 0; i < kFrames; ++i) {
    camera.look(world, frame);
    ASSERT_EQ(frame.ball->position_m, Vec2(0, 2.8)) << "nearest to the last ball";
    for (const BallObservation& ball : camera.others().balls) {
      ++count;
      EXPECT_FALSE(ball.height_m);
      const double ahead_m = ahead_of_a_robot_m(world, ball.position_m);
      EXPECT_GE(ahead_m, 0.12 - 1e-6);
      EXPECT_LE(ahead_m, 0.14 + 1e-6);
    }
  }
  const double expected = 0.06 * 12 * kFrames / 73.2;
  EXPECT_NEAR(count, expected, 5 * std::sqrt(expected));
}

class FalseDetectionsUnder : public testing::TestWithParam<const char*> {};

TEST_P(FalseDetectionsUnder, AreAsFrequentAsMeasured) {
  EXPECT_GE(vision_of(GetParam()).false_balls_per_s, 0.0015);
  EXPECT_LE(vision_of(GetParam()).false_balls_per_s, 0.06);
  EXPECT_EQ(vision_of(GetParam()).misread_numbers, 3e-5);
}

INSTANTIATE_TEST_SUITE_P(Presets, FalseDetectionsUnder, testing::Values("rc2026-b", "rc2026-a"),
                         name_of_camera_preset);

// The number of frames with a false ball instead of the ball of the full world.
int frames_with_false_ball(Camera& camera, int frames) {
  const WorldState world = full_world();
  Frame frame;
  int replaced = 0;
  for (int i = 0; i < frames; ++i) {
    camera.look(world, frame);
    const bool is_false = frame.ball && (frame.ball->position_m - Vec2(0, 2.8)).norm() > 0.1;
    replaced += is_false ? 1 : 0;
  }
  return replaced;
}

TEST(FalseBalls, ReplaceAMissedBallForOneFrame) {
  VisionParameters vision = steady("rc2026-b");
  vision.false_balls_per_s = 10;
  vision.ball_misses = 0.5;
  Camera camera(vision, field_of("2026-b"), 73.2, 1);
  EXPECT_GT(frames_with_false_ball(camera, 1000), 100);
}

TEST(MisreadNumbers, AreThoseOfATeamMate) {
  VisionParameters vision = steady("rc2026-b");
  vision.misread_numbers = 0.01;
  constexpr int kFrames = 20000;
  Camera camera(vision, field_of("2026-b"), 73.2, 1);
  const WorldState world = full_world();
  Frame frame;
  int doubles = 0;
  for (int i = 0; i < kFrames; ++i) {
    camera.look(world, frame);
    for (const Side side : kSides) {
      const auto& others = camera.others().robots[side];
      doubles += static_cast<int>(others.size());
      for (std::size_t k = 1; k < frame.robots[side].size(); ++k) {
        ASSERT_LT(frame.robots[side][k - 1].number, frame.robots[side][k].number) << i;
      }
      for (const RobotObservation& robot : others) ASSERT_EQ(robot.number % 2, 0);
    }
  }
  const double expected = 0.01 * 12 * kFrames;
  EXPECT_NEAR(doubles, expected, 0.03 * expected);  // if both robots are misread, none is double
}

class OtherDetectionsUnder : public testing::TestWithParam<const char*> {};

// The number of frames in which the camera reports other detections.
int frames_with_others(Camera& camera, int frames) {
  Frame frame;
  int with_others = 0;
  for (int i = 0; i < frames; ++i) {
    camera.look(full_world(), frame);
    with_others += camera.others().is_empty() ? 0 : 1;
  }
  return with_others;
}

TEST_P(OtherDetectionsUnder, AreEmpty) {
  Camera camera = camera_of(GetParam());
  EXPECT_EQ(frames_with_others(camera, 1000), 0);
}

INSTANTIATE_TEST_SUITE_P(OlderPresets, OtherDetectionsUnder,
                         testing::Values("paper", "none", "friendly", "rc2021", "realistic"),
                         name_of_camera_preset);

}  // namespace
}  // namespace autoref::sim
