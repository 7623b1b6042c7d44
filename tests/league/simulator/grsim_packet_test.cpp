#include "league/simulator/grsim_packet.hpp"

#include <gtest/gtest.h>

#include <string>

#include "soccer/units.hpp"

namespace autoref::league {
namespace {

const PerSide<int> kSix{{6, 6}};

grsim::Packet standing(bool is_yellow, std::uint32_t robot) {
  grsim::Packet packet;
  packet.mutable_commands()->set_timestamp(0);
  packet.mutable_commands()->set_isteamyellow(is_yellow);
  grsim::RobotCommand& command = *packet.mutable_commands()->add_robot_commands();
  command.set_id(robot);
  command.set_kickspeedx(0);
  command.set_kickspeedz(0);
  command.set_veltangent(0);
  command.set_velnormal(0);
  command.set_velangular(0);
  command.set_spinner(false);
  command.set_wheelsspeed(false);
  return packet;
}

RobotCommand command_in(const grsim::Packet& packet) {
  const GrsimPacket read = read_grsim_packet(packet.SerializeAsString(), kSix);
  EXPECT_EQ(read.commands.updates.size(), 1U);
  return read.commands.updates.empty() ? RobotCommand{}
                                       : command_of(read.commands.updates.front(), Vec2(1, 0), {});
}

TEST(GrsimPacket, CommandsOneTeam) {
  EXPECT_EQ(read_grsim_packet(standing(true, 0).SerializeAsString(), kSix).side, Side::kWest);
  EXPECT_EQ(read_grsim_packet(standing(false, 0).SerializeAsString(), kSix).side, Side::kEast);
}

TEST(GrsimPacket, VelocitiesAreForwardLeftAndCounterclockwise) {
  grsim::Packet packet = standing(true, 4);
  grsim::RobotCommand& sent = *packet.mutable_commands()->mutable_robot_commands(0);
  sent.set_veltangent(1.5);
  sent.set_velnormal(-0.5);
  sent.set_velangular(2);
  sent.set_spinner(true);
  const RobotCommand command = command_in(packet);
  EXPECT_EQ(command.velocity_mps, Vec2(1.5, -0.5));
  EXPECT_EQ(command.angular_velocity_radps, 2);
  EXPECT_TRUE(command.dribble);
}

// A robot that drives forward at 1 m/s: the left wheels turn one way, the right wheels the other.
// The speeds are -sin(angle) / 27 mm for wheels at 60, 135, 225 and 300 degrees.
TEST(GrsimPacket, WheelSpeedsDriveForward) {
  grsim::Packet packet = standing(true, 0);
  grsim::RobotCommand& sent = *packet.mutable_commands()->mutable_robot_commands(0);
  sent.set_wheelsspeed(true);
  sent.set_wheel1(-32.0750F);
  sent.set_wheel2(-26.1891F);
  sent.set_wheel3(26.1891F);
  sent.set_wheel4(32.0750F);
  const RobotCommand command = command_in(packet);
  EXPECT_NEAR(command.velocity_mps.x(), 1, 1e-4);
  EXPECT_NEAR(command.velocity_mps.y(), 0, 1e-4);
  EXPECT_NEAR(command.angular_velocity_radps, 0, 1e-3);
}

TEST(GrsimPacket, AnUpwardKickSpeedMakesAChip) {
  grsim::Packet packet = standing(true, 0);
  grsim::RobotCommand& sent = *packet.mutable_commands()->mutable_robot_commands(0);
  sent.set_kickspeedx(4);
  EXPECT_FALSE(command_in(packet).chip);
  EXPECT_NEAR(command_in(packet).kick_mps, 4, 1e-6);
  sent.set_kickspeedz(4);
  EXPECT_TRUE(command_in(packet).chip);
  EXPECT_NEAR(command_in(packet).kick_mps, 4, 1e-6);
}

TEST(GrsimPacket, ReplacesRobotsAndBall) {
  grsim::Packet packet;
  packet.mutable_replacement()->mutable_ball()->set_x(1);
  packet.mutable_replacement()->mutable_ball()->set_y(-2);
  grsim::RobotReplacement& robot = *packet.mutable_replacement()->add_robots();
  robot.set_x(0.5);
  robot.set_y(0.25);
  robot.set_dir(90);
  robot.set_id(3);
  robot.set_yellowteam(false);
  const GrsimPacket read = read_grsim_packet(packet.SerializeAsString(), kSix);
  ASSERT_EQ(read.teleports.size(), 2U);
  EXPECT_EQ(std::get<BallTeleport>(read.teleports[0]).y_m, -2.0);
  const auto& teleport = std::get<RobotTeleport>(read.teleports[1]);
  EXPECT_EQ(teleport.robot, (RobotId{Side::kEast, 3}));
  EXPECT_NEAR(*teleport.heading_rad, kPi / 2, 1e-12);
  EXPECT_EQ(teleport.vx_mps, 0.0);
}

// The code of the first error in the packet; empty if there is none.
std::string grsim_error(const std::string& bytes) {
  const GrsimPacket packet = read_grsim_packet(bytes, kSix);
  return packet.commands.errors.empty() ? "" : packet.commands.errors.front().code;
}

TEST(GrsimPacket, WhatIsImpossibleIsAnError) {
  EXPECT_EQ(grsim_error("garbage"), "PACKET");
  EXPECT_EQ(grsim_error(standing(true, 6).SerializeAsString()), "ROBOT_ID");
  grsim::Packet fast = standing(true, 0);
  fast.mutable_commands()->mutable_robot_commands(0)->set_veltangent(1e9F);
  EXPECT_EQ(grsim_error(fast.SerializeAsString()), "NOT_FINITE");
  grsim::Packet far_away;
  far_away.mutable_replacement()->mutable_ball()->set_x(1e9);
  EXPECT_EQ(grsim_error(far_away.SerializeAsString()), "REPLACEMENT");
}

}  // namespace
}  // namespace autoref::league
