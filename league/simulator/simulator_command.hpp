// Requests that a program sends to the simulator's control port.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "league/messages/simulation.pb.h"
#include "league/simulator/command_update.hpp"
#include "soccer/field.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

// Changes to a robot's specification. Members that are not set leave the value unchanged.
struct SpecUpdate {
  RobotId robot;  // west is yellow
  std::optional<double> mass_kg;
  std::optional<double> kick_limit_mps;
  std::optional<double> chip_limit_mps;
  std::optional<double> acceleration_mps2;
  std::optional<double> angular_acceleration_radps2;
  std::optional<double> braking_mps2;
  std::optional<double> speed_mps;
  std::optional<double> angular_speed_radps;
};

// Limits of a simulation's speed relative to real time; 0 pauses it.
inline constexpr double kSlowestSimulation = 0.01;
inline constexpr double kFastestSimulation = 1000;

struct SimulatorRequest {
  std::vector<Teleport> teleports;
  std::optional<double> speed;  // speed of the simulation, relative to real time; 0 pauses it
  std::optional<int> vision_port;
  std::optional<Field> field;
  std::vector<SpecUpdate> specs;
  std::vector<PacketError> errors;
};

// The request in a SimulatorCommand for teams of `robots` robots. Invalid parts are left out.
// Codes: PACKET, ROBOT_ID, TELEPORT, SPEED, VISION_PORT, GEOMETRY, ROBOT_SPECS (a value is
// impossible), UNSUPPORTED_SPECS (radius, height, dribbler distance, wheel angles and custom specs
// are fixed), UNSUPPORTED_REALISM (choose the realism in the scenario).
SimulatorRequest read_simulator_command(std::string_view bytes, const PerSide<int>& robots);
SimulatorRequest request_of(const simulation::SimulatorCommand& command,
                            const PerSide<int>& robots);

}  // namespace autoref::league
