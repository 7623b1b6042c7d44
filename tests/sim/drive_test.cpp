#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/scene.hpp"

namespace autoref::sim {
namespace {

// A single robot that starts from rest in the west.
struct Lane : Scene {
  explicit Lane(double speed_factor = 1.0, double acceleration_factor = 1.0)
      : Scene(quiet(), handicapped(speed_factor, acceleration_factor)) {
    put_robot(kWest0, {-2.5, 0});
    put_robot(kEast0, {2.5, 1.8}, {-1, 0});
    put_ball({0, -1.5});
  }
  static PerSide<TeamSpec> handicapped(double speed_factor, double acceleration_factor) {
    PerSide<TeamSpec> both = specs(1, 1);
    both[Side::kWest].robots[0].speed_factor = speed_factor;
    both[Side::kWest].robots[0].acceleration_factor = acceleration_factor;
    return both;
  }
  double speed_mps() const { return robot(kWest0).velocity_mps.norm(); }
};

TEST(Robot, ReachesThreeMetresPerSecondInOneSecond) {
  Lane lane;
  lane.command(kWest0).velocity_mps = {10, 0};
  lane.frames(30);
  EXPECT_NEAR(lane.speed_mps(), 1.5, 0.02);
  lane.frames(32);
  EXPECT_NEAR(lane.speed_mps(), 3.0, 0.001);
}

TEST(Robot, BrakesAtFiveMetresPerSecondSquared) {
  Lane lane;
  lane.put_robot(kWest0, {-2.5, 0}, {1, 0}, {3, 0});
  lane.frames(60);
  EXPECT_NEAR(lane.robot(kWest0).position_m.x() + 2.5, 3.0 * 3.0 / (2 * 5.0), 0.001);
  EXPECT_EQ(lane.speed_mps(), 0.0);
}

// The wheels at 35 degrees drive along 125 degrees; they limit a robot braking in that direction to
// 4.5 m/s^2, below the overall limit of 5.
TEST(Robot, BrakesLessAlongAWheel) {
  Lane lane;
  const double angle_rad = 125.0 * kPi / 180.0;
  lane.put_robot(kWest0, {0, -0.5}, {1, 0}, 2.0 * Vec2(std::cos(angle_rad), std::sin(angle_rad)));
  lane.frames(12);
  EXPECT_NEAR(2.0 - lane.speed_mps(), 4.5 * 12 / 60, 0.01);
  EXPECT_NEAR(lane.robot(kWest0).velocity_mps.x() / lane.speed_mps(), std::cos(angle_rad), 1e-3);
}

TEST(Robot, TurnsAtFortyRadiansPerSecondSquaredUpToFifteen) {
  Lane lane;
  lane.command(kWest0).angular_velocity_radps = 100;
  lane.frames(6);
  EXPECT_NEAR(lane.robot(kWest0).angular_velocity_radps, 4.0, 0.01);
  lane.frames(30);
  EXPECT_NEAR(lane.robot(kWest0).angular_velocity_radps, 15.0, 0.01);
}

// Rim acceleration of the back wheel: sin(135 deg) * 3 + 0.08 * 40 = 5.3, more than 4.5.
TEST(Robot, SharesItsWheelsBetweenDrivingAndTurning) {
  Lane lane;
  lane.command(kWest0).velocity_mps = {3, 0};
  lane.command(kWest0).angular_velocity_radps = 15;
  lane.frame();
  const double share = 4.5 / (3.0 * std::sqrt(0.5) + 0.08 * 40);
  EXPECT_NEAR(lane.speed_mps(), 3.0 * share / 60, 0.002);
  EXPECT_NEAR(lane.robot(kWest0).angular_velocity_radps, 40.0 * share / 60, 0.02);
}

TEST(Robot, MovesInItsOwnFrame) {
  Lane lane;
  lane.put_robot(kWest0, {0, 0}, {0, 1});
  lane.command(kWest0).velocity_mps = {1, 0};
  lane.frames(60);
  EXPECT_NEAR(lane.robot(kWest0).position_m.x(), 0.0, 1e-3);
  EXPECT_GT(lane.robot(kWest0).position_m.y(), 0.7);
}

TEST(Robot, KeepsItsMassAfterTheBallHasLeft) {
  Lane lane;
  lane.put_ball({-2.2, 0});
  lane.frame();
  lane.put_ball({0, -1.5});
  lane.frame();
  lane.command(kWest0).velocity_mps = {3, 0};
  lane.frames(30);
  EXPECT_NEAR(lane.speed_mps(), 1.5, 0.02);
}

class Handicap : public testing::TestWithParam<double> {};

TEST_P(Handicap, ScalesTopSpeedAndAcceleration) {
  const double factor = GetParam();
  Lane lane(factor, factor);
  lane.command(kWest0).velocity_mps = {10, 0};
  lane.frames(30);
  EXPECT_NEAR(lane.speed_mps(), 1.5 * factor, 0.02);
  lane.frames(40);
  EXPECT_NEAR(lane.speed_mps(), 3.0 * factor, 0.002);
}

TEST_P(Handicap, ScalesBraking) {
  const double factor = GetParam();
  Lane lane(1.0, factor);
  lane.put_robot(kWest0, {-2.5, 0}, {1, 0}, {2, 0});
  lane.frames(60);
  EXPECT_NEAR(lane.robot(kWest0).position_m.x() + 2.5, 2.0 * 2.0 / (2 * 5.0 * factor), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Factors, Handicap, testing::Values(1.0, 0.8, 0.5));

TEST(RobotsThatPushEachOther, AreBalancedWhicheverCameFirst) {
  Scene scene;
  scene.put_robot(kWest0, {-0.09, 0}, {1, 0});
  scene.put_robot(kEast0, {0.09, 0}, {-1, 0});
  scene.put_ball({0, 1.5});
  scene.command(kWest0).velocity_mps = {3, 0};
  scene.command(kEast0).velocity_mps = {3, 0};
  scene.frames(60);
  EXPECT_NEAR(scene.robot(kWest0).position_m.x(), -0.09, 0.002);
  EXPECT_NEAR(scene.robot(kEast0).position_m.x(), 0.09, 0.002);
}

TEST(RobotsThatCollide, DoNotPassThroughEachOther) {
  Scene scene;
  scene.put_robot(kWest0, {-1, 0}, {1, 0}, {3, 0});
  scene.put_robot(kEast0, {1, 0.02}, {-1, 0}, {3 * -1.0, 0});
  scene.put_ball({0, 1.5});
  const auto apart_m = [&] {
    return (scene.robot(kWest0).position_m - scene.robot(kEast0).position_m).norm();
  };
  EXPECT_GT(scene.least_over(60, apart_m), 0.178);
}

TEST(Motors, VarySpeedsByAboutOnePercent) {
  RobotSpec noisy = quiet_robot();
  noisy.body.speed_noise = 0.01;
  Scene scene(quiet(), specs(1, 1, noisy));
  scene.put_robot(kWest0, {-2.5, 0});
  scene.command(kWest0).velocity_mps = {1, 0};
  scene.frames(30);
  const auto off2 = [&] { return std::pow(scene.robot(kWest0).velocity_mps.x() - 1.0, 2); };
  EXPECT_NEAR(std::sqrt(scene.mean_over(100, off2)), 0.01, 0.003);
}

}  // namespace
}  // namespace autoref::sim
