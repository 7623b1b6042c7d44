#include "league/simulator/command_update.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "soccer/units.hpp"

namespace autoref::league {
namespace {

const Vec2 kNorth(0, 1);

// The wheels of grSim's robot, in the order front right, back right, back left, front left.
WheelPositions grsim_wheels() {
  return {{to_radians(300), to_radians(225), to_radians(135), to_radians(60)}, 0.09};
}

// The rim speed of each wheel for a velocity: the part along the wheel's tangent, and the turn.
WheelSpeeds speeds_for(const LocalVelocity& velocity, const WheelPositions& positions) {
  WheelSpeeds wheels;
  for (std::size_t i = 0; i < 4; ++i) {
    const double angle = positions.angles_rad.at(i);
    wheels.speeds_mps.at(i) = -std::sin(angle) * velocity.velocity_mps.x() +
                              std::cos(angle) * velocity.velocity_mps.y() +
                              positions.distance_m * velocity.angular_radps;
  }
  return wheels;
}

TEST(CommandUpdate, WheelSpeedsGiveTheVelocityTheyBelongTo) {
  const LocalVelocity velocity{Vec2(1.2, -0.7), 2.5};
  const LocalVelocity found = velocity_of(speeds_for(velocity, grsim_wheels()), grsim_wheels());
  EXPECT_NEAR(found.velocity_mps.x(), 1.2, 1e-9);
  EXPECT_NEAR(found.velocity_mps.y(), -0.7, 1e-9);
  EXPECT_NEAR(found.angular_radps, 2.5, 1e-9);
}

TEST(CommandUpdate, EqualWheelSpeedsTurnTheRobotCounterclockwise) {
  const LocalVelocity found = velocity_of({{0.9, 0.9, 0.9, 0.9}}, grsim_wheels());
  EXPECT_GT(found.angular_radps, 0);
}

TEST(CommandUpdate, AGlobalVelocityIsRotatedIntoTheRobotsFrame) {
  CommandUpdate update;
  update.motion = GlobalVelocity{Vec2(0, 2), 0.5};
  const RobotCommand command = command_of(update, kNorth, {});
  EXPECT_NEAR(command.velocity_mps.x(), 2, 1e-12);
  EXPECT_NEAR(command.velocity_mps.y(), 0, 1e-12);
  EXPECT_EQ(command.angular_velocity_radps, 0.5);
}

TEST(CommandUpdate, WhatIsNotSetStays) {
  CommandUpdate held;
  held.motion = LocalVelocity{Vec2(1, 0), 0};
  held.kick_speed_mps = 4;
  held.dribble = true;
  CommandUpdate update;
  update.robot = 3;
  update.kick_speed_mps = 0;
  merge(update, held);
  const RobotCommand command = command_of(held, kNorth, {});
  EXPECT_EQ(held.robot, 3);
  EXPECT_EQ(command.velocity_mps, Vec2(1, 0));
  EXPECT_EQ(command.kick_mps, 0);
  EXPECT_TRUE(command.dribble);
}

TEST(CommandUpdate, AnEmptyUpdateStandsStill) {
  const RobotCommand command = command_of({}, kNorth, {});
  EXPECT_EQ(command.velocity_mps, Vec2(0, 0));
  EXPECT_EQ(command.kick_mps, 0);
  EXPECT_FALSE(command.chip || command.dribble);
}

TEST(CommandUpdate, AFlatKickHasItsWholeSpeedOverGround) {
  CommandUpdate update;
  update.kick_speed_mps = 6.5;
  update.kick_angle_rad = 0;
  EXPECT_EQ(command_of(update, kNorth, {}).kick_mps, 6.5);
}

// At 45 degrees the speed over ground is the speed in space times the cosine of 45 degrees. The
// first hop is 2 v_ground v_up / g long.
class ChipKickAt : public testing::TestWithParam<int> {};  // angle in degrees

TEST_P(ChipKickAt, KeepsTheLengthOfItsFirstHop) {
  const double angle_rad = to_radians(GetParam());
  CommandUpdate update;
  update.kick_speed_mps = 5;
  update.kick_angle_rad = angle_rad;
  const RobotCommand command = command_of(update, kNorth, {});
  EXPECT_TRUE(command.chip);
  EXPECT_NEAR(command.kick_mps * command.kick_mps, std::sin(angle_rad) * std::cos(angle_rad) * 25,
              1e-9);
}

INSTANTIATE_TEST_SUITE_P(Degrees, ChipKickAt, testing::Values(20, 45, 70),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace autoref::league
