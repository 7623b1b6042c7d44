// grSim's packets: commands, replacements and the status of robots.
#pragma once

#include <bitset>
#include <optional>
#include <string_view>
#include <vector>

#include "league/messages/grsim.pb.h"
#include "league/simulator/command_update.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

struct GrsimPacket {
  Side side = Side::kWest;  // the side that the commands are for; yellow is west
  CommandPacket commands;   // errors have the codes of robot_control.hpp
  std::vector<Teleport> teleports;
};

// Reads a packet for teams of `robots` robots. Wheel speeds are converted to velocities as for
// grSim's own robot. Kicks with an upward speed of at most 0.1 mm/s are flat.
GrsimPacket read_grsim_packet(std::string_view bytes, const PerSide<int>& robots);

// A robot's report: whether the ball is in its dribbler zone, and its last kick.
struct GrsimStatus {
  bool infrared = false;
  bool flat_kick = false;
  bool chip_kick = false;
  bool operator==(const GrsimStatus&) const = default;
};

void add_status(int robot, const GrsimStatus& status, grsim::RobotsStatus& message);

}  // namespace autoref::league
