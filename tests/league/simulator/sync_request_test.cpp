#include "league/simulator/sync_request.hpp"

#include <gtest/gtest.h>

#include <string>

#include "league/messages/simulation.pb.h"

namespace autoref::league {
namespace {

const PerSide<int> kRobots{{6, 6}};

simulation::SimulationSyncRequest with_step(float step_s) {
  simulation::SimulationSyncRequest message;
  message.set_sim_step(step_s);
  return message;
}

TEST(SyncRequest, IsToldFromOtherPacketsByItsFields) {
  EXPECT_TRUE(is_sync_request(with_step(0.016F).SerializeAsString()));
  simulation::SimulationSyncRequest commands;
  commands.mutable_robot_control()->add_robot_commands()->set_id(1);
  EXPECT_TRUE(is_sync_request(commands.SerializeAsString()));
  simulation::RobotControl control;
  control.add_robot_commands()->set_id(1);
  EXPECT_FALSE(is_sync_request(control.SerializeAsString()));
  simulation::SimulatorCommand command;
  command.mutable_control()->set_simulation_speed(1);
  command.mutable_config()->set_vision_port(1);
  EXPECT_FALSE(is_sync_request(command.SerializeAsString()));
  EXPECT_FALSE(is_sync_request(""));
  EXPECT_FALSE(is_sync_request("garbage"));
}

TEST(SyncRequest, ContainsStepCommandsAndControl) {
  simulation::SimulationSyncRequest message = with_step(0.5F);
  message.mutable_robot_control()->add_robot_commands()->set_id(2);
  message.mutable_simulator_command()->mutable_control()->mutable_teleport_ball()->set_x(1);
  const SyncRequest request = read_sync_request(message.SerializeAsString(), Side::kWest, kRobots);
  EXPECT_EQ(request.step_s, 0.5);
  ASSERT_EQ(request.commands.updates.size(), 1U);
  EXPECT_EQ(request.commands.updates.front().robot, 2);
  EXPECT_EQ(request.control.teleports.size(), 1U);
  EXPECT_TRUE(request.commands.errors.empty());
}

// The code of the first error in the request; empty if there is none.
std::string sync_error(const simulation::SimulationSyncRequest& message, std::optional<Side> side) {
  const SyncRequest request = read_sync_request(message.SerializeAsString(), side, kRobots);
  return request.commands.errors.empty() ? "" : request.commands.errors.front().code;
}

TEST(SyncRequest, WhatIsWrongIsAnErrorOfTheResponse) {
  EXPECT_EQ(sync_error(with_step(-1), Side::kWest), "STEP");
  EXPECT_EQ(sync_error(with_step(11), Side::kWest), "STEP");
  simulation::SimulationSyncRequest commands = with_step(0.1F);
  commands.mutable_robot_control()->add_robot_commands()->set_id(9);
  EXPECT_EQ(sync_error(commands, Side::kWest), "ROBOT_ID");
  EXPECT_EQ(sync_error(commands, std::nullopt), "PACKET");
  EXPECT_EQ(read_sync_request("\x0d", Side::kWest, kRobots).commands.errors.front().code, "PACKET");
}

TEST(SyncRequest, TheResponseContainsDetectionsAndFeedback) {
  CommandPacket commands;
  commands.updates.resize(1);
  simulation::SimulationSyncResponse response;
  ASSERT_TRUE(response.ParseFromString(sync_response({"one", "two"}, commands, {})));
  EXPECT_EQ(response.detection_size(), 2);
  EXPECT_EQ(response.robot_control_response().feedback_size(), 1);
}

}  // namespace
}  // namespace autoref::league
