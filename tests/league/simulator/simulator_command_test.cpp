#include "league/simulator/simulator_command.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "league/field_message.hpp"

namespace autoref::league {
namespace {

const PerSide<int> kSixRobots{{6, 6}};

std::string first_code(const SimulatorRequest& request) {
  return request.errors.empty() ? "" : request.errors.front().code;
}

TEST(SimulatorCommand, TeleportsMayBePartial) {
  simulation::SimulatorCommand command;
  command.mutable_control()->mutable_teleport_ball()->set_vx(2);
  simulation::TeleportRobot& robot = *command.mutable_control()->add_teleport_robot();
  robot.mutable_id()->set_id(5);
  robot.mutable_id()->set_team(2);
  robot.set_x(1);
  robot.set_present(false);
  const SimulatorRequest request = read_simulator_command(command.SerializeAsString(), kSixRobots);
  EXPECT_EQ(first_code(request), "");
  ASSERT_EQ(request.teleports.size(), 2U);
  const auto& ball = std::get<BallTeleport>(request.teleports[0]);
  EXPECT_EQ(ball.vx_mps, 2.0);
  EXPECT_EQ(ball.x_m, std::nullopt);
  const auto& moved = std::get<RobotTeleport>(request.teleports[1]);
  EXPECT_EQ(moved.robot, (RobotId{Side::kEast, 5}));
  EXPECT_EQ(moved.x_m, 1.0);
  EXPECT_EQ(moved.y_m, std::nullopt);
  EXPECT_EQ(moved.is_present, false);
}

TEST(SimulatorCommand, SetsSpeedAndVisionPort) {
  simulation::SimulatorCommand command;
  command.mutable_control()->set_simulation_speed(4);
  command.mutable_config()->set_vision_port(10020);
  const SimulatorRequest request = request_of(command, kSixRobots);
  EXPECT_EQ(request.speed, 4.0);
  EXPECT_EQ(request.vision_port, 10020);
}

TEST(SimulatorCommand, ContainsTheField) {
  Field field;
  field.length_m = 9;
  Geometry geometry;
  fill_geometry(field, {}, geometry);
  simulation::SimulatorCommand command;
  command.mutable_config()->set_geometry(geometry.SerializeAsString());
  const SimulatorRequest request = request_of(command, kSixRobots);
  ASSERT_TRUE(request.field.has_value());
  EXPECT_NEAR(request.field->length_m, 9, 1e-3);
}

TEST(SimulatorCommand, ContainsRobotsLimits) {
  simulation::SimulatorCommand command;
  simulation::RobotSpecs& specs = *command.mutable_config()->add_robot_specs();
  specs.mutable_id()->set_id(1);
  specs.mutable_id()->set_team(1);
  specs.set_mass(2);
  specs.mutable_limits()->set_vel_absolute_max(2.5);
  const SimulatorRequest request = request_of(command, kSixRobots);
  ASSERT_EQ(request.specs.size(), 1U);
  EXPECT_EQ(request.specs[0].robot, (RobotId{Side::kWest, 1}));
  EXPECT_EQ(request.specs[0].speed_mps, 2.5);
  EXPECT_EQ(request.specs[0].braking_mps2, std::nullopt);
}

TEST(SimulatorCommand, WhatIsImpossibleHasACode) {
  EXPECT_EQ(first_code(read_simulator_command("garbage", kSixRobots)), "PACKET");
  simulation::SimulatorCommand speed;
  for (const float impossible : {-1.0F, 1e-6F, 0.009F, 1001.0F, std::nanf("")}) {
    speed.mutable_control()->set_simulation_speed(impossible);
    EXPECT_EQ(first_code(request_of(speed, kSixRobots)), "SPEED") << impossible;
  }
  for (const float possible : {0.0F, 0.01F, 1000.0F}) {
    speed.mutable_control()->set_simulation_speed(possible);
    EXPECT_TRUE(request_of(speed, kSixRobots).errors.empty()) << possible;
  }
  simulation::SimulatorCommand ball;
  ball.mutable_control()->mutable_teleport_ball()->set_x(std::numeric_limits<float>::infinity());
  EXPECT_EQ(first_code(request_of(ball, kSixRobots)), "TELEPORT");
  simulation::SimulatorCommand robot;
  robot.mutable_control()->add_teleport_robot()->mutable_id()->set_id(0);
  EXPECT_EQ(first_code(request_of(robot, kSixRobots)), "ROBOT_ID");
  simulation::SimulatorCommand port;
  port.mutable_config()->set_vision_port(0);
  EXPECT_EQ(first_code(request_of(port, kSixRobots)), "VISION_PORT");
  simulation::SimulatorCommand geometry;
  geometry.mutable_config()->set_geometry("x");
  EXPECT_EQ(first_code(request_of(geometry, kSixRobots)), "GEOMETRY");
  simulation::SimulatorCommand realism;
  realism.mutable_config()->mutable_realism_config()->add_custom();
  EXPECT_EQ(first_code(request_of(realism, kSixRobots)), "UNSUPPORTED_REALISM");
  simulation::SimulatorCommand radius;
  simulation::RobotSpecs& specs = *radius.mutable_config()->add_robot_specs();
  specs.mutable_id()->set_id(1);
  specs.mutable_id()->set_team(1);
  specs.set_radius(0.08F);
  EXPECT_EQ(first_code(request_of(radius, kSixRobots)), "UNSUPPORTED_SPECS");
}

}  // namespace
}  // namespace autoref::league
