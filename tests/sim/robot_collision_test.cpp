// Robot collisions and the ball's velocity after a touch: ground truth for evaluating referees.
#include <gtest/gtest.h>

#include <vector>

#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

std::vector<RobotCollision> collisions_in(Scene& scene, int frames) {
  std::vector<RobotCollision> met;
  for (int i = 0; i < frames; ++i) {
    scene.frame();
    for (const RobotCollision& collision : scene.world.collisions()) met.push_back(collision);
  }
  return met;
}

TEST(RobotCollisions, ReportTheRobotsAndTheirVelocitiesJustBefore) {
  Scene scene;
  scene.put_ball({0, 1});
  scene.put_robot(kWest0, {-0.0925, 0}, {1, 0}, {1.0, 0});
  scene.put_robot(kEast0, {0.0925, 0}, {-1, 0}, {-0.5, 0});
  const std::vector<RobotCollision> met = collisions_in(scene, 3);
  ASSERT_FALSE(met.empty());
  EXPECT_EQ(met.front().robots[0], kWest0);
  EXPECT_EQ(met.front().robots[1], kEast0);
  EXPECT_NEAR(met.front().velocities_mps[0].x(), 1.0, 0.15);
  EXPECT_NEAR(met.front().velocities_mps[1].x(), -0.5, 0.15);
  EXPECT_NEAR((met.front().centres_m[1] - met.front().centres_m[0]).norm(), 0.18, 0.01);
}

TEST(RobotCollisions, IgnoreRobotsThatPassEachOther) {
  Scene scene;
  scene.put_robot(kWest0, {-0.10, 0.10}, {1, 0}, {1.0, 0});
  scene.put_robot(kEast0, {0.10, -0.10}, {-1, 0}, {-1.0, 0});
  EXPECT_TRUE(collisions_in(scene, 10).empty());
}

TEST(Touches, ReportTheBallsVelocityAfterAKick) {
  Scene scene;
  scene.put_robot(kWest0, {0, 0});
  scene.put_ball_at_plate(kWest0);
  scene.command(kWest0).kick_mps = 4.0;
  scene.frame();
  ASSERT_FALSE(scene.world.touches().empty());
  const Touch& kick = scene.world.touches().front();
  EXPECT_TRUE(kick.is_kick);
  EXPECT_NEAR(kick.ball_mps.norm(), 4.0, 0.01);
  EXPECT_EQ(kick.vertical_mps, 0.0);
}

}  // namespace
}  // namespace autoref::sim
