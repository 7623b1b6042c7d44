// Lock-step: a program asks the simulator to advance by some time, and receives what the cameras
// saw.
#pragma once

#include <bitset>
#include <string>
#include <string_view>
#include <vector>

#include "league/simulator/command_update.hpp"
#include "league/simulator/simulator_command.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

// Whether a packet is a SimulationSyncRequest with a step or with robot commands, rather than a
// RobotControl or a SimulatorCommand, whose protobuf fields have other numbers and types.
bool is_sync_request(std::string_view bytes);

struct SyncRequest {
  bool is_readable = false;  // false if the packet is something else
  double step_s = 0;         // if 0, the commands are recorded but time does not advance
  CommandPacket commands;    // with the errors of the whole request
  SimulatorRequest control;
};

// Reads a request from `side`'s team, or, without a side, one at the control port, where robot
// commands are an error. The codes are those of read_robot_control() and read_simulator_command(),
// plus STEP for a step that is not from 0 to 10 s.
SyncRequest read_sync_request(std::string_view bytes, std::optional<Side> side,
                              const PerSide<int>& robots);

// The response, which contains `detections` as serialized DetectionFrames.
std::string sync_response(const std::vector<std::string>& detections, const CommandPacket& commands,
                          const std::bitset<kMaxRobots>& dribbler_contact);

}  // namespace autoref::league
