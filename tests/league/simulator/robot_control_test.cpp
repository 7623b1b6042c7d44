#include "league/simulator/robot_control.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace autoref::league {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

simulation::RobotControl local_velocity(std::uint32_t robot, float forward, float left,
                                        float turn) {
  simulation::RobotControl control;
  simulation::RobotCommand& command = *control.add_robot_commands();
  command.set_id(robot);
  simulation::MoveLocalVelocity& velocity =
      *command.mutable_move_command()->mutable_local_velocity();
  velocity.set_forward(forward);
  velocity.set_left(left);
  velocity.set_angular(turn);
  return control;
}

std::string code_of(const CommandPacket& packet) {
  return packet.errors.empty() ? "" : packet.errors.front().code;
}

TEST(RobotControl, ContainsTheUpdateOfEachRobot) {
  simulation::RobotControl control = local_velocity(2, 1.5F, -0.5F, 3);
  control.mutable_robot_commands(0)->set_kick_speed(6);
  control.mutable_robot_commands(0)->set_dribbler_speed(1000);
  const CommandPacket packet = read_robot_control(control.SerializeAsString(), 6);
  ASSERT_EQ(packet.updates.size(), 1U);
  EXPECT_EQ(code_of(packet), "");
  const CommandUpdate& update = packet.updates.front();
  EXPECT_EQ(update.robot, 2);
  EXPECT_EQ(std::get<LocalVelocity>(*update.motion).velocity_mps, Vec2(1.5, -0.5));
  EXPECT_EQ(update.kick_speed_mps, 6.0);
  EXPECT_EQ(update.kick_angle_rad, std::nullopt);
  EXPECT_EQ(update.dribble, true);
}

TEST(RobotControl, WheelSpeedsKeepTheirOrder) {
  simulation::RobotControl control;
  control.add_robot_commands()->set_id(0);
  simulation::MoveWheelVelocity& wheels =
      *control.mutable_robot_commands(0)->mutable_move_command()->mutable_wheel_velocity();
  wheels.set_front_right(1);
  wheels.set_back_right(2);
  wheels.set_back_left(3);
  wheels.set_front_left(4);
  const CommandPacket packet = updates_of(control, 6);
  ASSERT_EQ(packet.updates.size(), 1U);
  const std::array<double, 4> speeds = {1, 2, 3, 4};
  EXPECT_EQ(std::get<WheelSpeeds>(*packet.updates.front().motion).speeds_mps, speeds);
}

TEST(RobotControl, AnUnknownRobotIsAnErrorAndTheOthersAreCommanded) {
  simulation::RobotControl control = local_velocity(6, 1, 0, 0);
  control.add_robot_commands()->set_id(5);
  const CommandPacket packet = updates_of(control, 6);
  EXPECT_EQ(code_of(packet), "ROBOT_ID");
  ASSERT_EQ(packet.updates.size(), 1U);
  EXPECT_EQ(packet.updates.front().robot, 5);
}

TEST(RobotControl, ImpossibleNumbersAreErrors) {
  EXPECT_EQ(code_of(updates_of(local_velocity(0, kNan, 0, 0), 6)), "NOT_FINITE");
  EXPECT_EQ(code_of(updates_of(local_velocity(0, 0, 101, 0), 6)), "NOT_FINITE");
  EXPECT_EQ(code_of(updates_of(local_velocity(0, 0, 0, -1001), 6)), "NOT_FINITE");
  simulation::RobotControl control = local_velocity(0, 1, 0, 0);
  control.mutable_robot_commands(0)->set_kick_speed(-1);
  EXPECT_EQ(code_of(updates_of(control, 6)), "NOT_FINITE");
}

void expect_kick_angle_refused(float angle_deg) {
  simulation::RobotControl control = local_velocity(0, 1, 0, 0);
  control.mutable_robot_commands(0)->set_kick_angle(angle_deg);
  EXPECT_EQ(code_of(updates_of(control, 6)), "ANGLE_VALUE") << angle_deg;
  EXPECT_TRUE(updates_of(control, 6).updates.empty()) << angle_deg;
}

TEST(RobotControl, AKickAngleIsFromZeroToNinetyDegrees) {
  expect_kick_angle_refused(-1);
  expect_kick_angle_refused(90.5);
  expect_kick_angle_refused(kNan);
}

TEST(RobotControl, GarbageIsAnError) {
  EXPECT_EQ(code_of(read_robot_control("not a packet", 6)), "PACKET");
  // Field 1 with a command that lacks its required id.
  EXPECT_EQ(code_of(read_robot_control(std::string("\x0a\x00", 2), 6)), "PACKET");
}

TEST(RobotControl, ErrorsAreBounded) {
  simulation::RobotControl control;
  for (int i = 0; i < 1000; ++i) control.add_robot_commands()->set_id(99);
  EXPECT_EQ(updates_of(control, 6).errors.size(), 16U);
}

TEST(RobotControl, TheResponseHasErrorsAndTheFeedbackOfCommandedRobots) {
  CommandPacket packet;
  packet.updates.resize(2);
  packet.updates[1].robot = 4;
  packet.errors = {{"ROBOT_ID", "unknown robot 9"}};
  simulation::RobotControlResponse response;
  fill_response(packet, std::bitset<kMaxRobots>(1U << 4U), response);
  ASSERT_EQ(response.errors_size(), 1);
  EXPECT_EQ(response.errors(0).code(), "ROBOT_ID");
  ASSERT_EQ(response.feedback_size(), 2);
  EXPECT_FALSE(response.feedback(0).dribbler_ball_contact());
  EXPECT_EQ(response.feedback(1).id(), 4U);
  EXPECT_TRUE(response.feedback(1).dribbler_ball_contact());
}

}  // namespace
}  // namespace autoref::league
