// Robot commands in the simulation protocol.
#pragma once

#include <bitset>
#include <string>
#include <string_view>

#include "league/messages/simulation.pb.h"
#include "league/simulator/command_update.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

// The largest magnitudes that commands can have; robots are far slower.
inline constexpr double kFastestCommand_mps = 100;
inline constexpr double kFastestCommand_radps = 1000;

// The updates in a RobotControl for a team of `robots` robots. A command with an error is left out
// entirely; at most 16 errors are listed. Codes: PACKET, ROBOT_ID, NOT_FINITE (also for velocities
// beyond the limits above), ANGLE_VALUE (not from 0 to 90 degrees).
CommandPacket read_robot_control(std::string_view bytes, int robots);
CommandPacket updates_of(const simulation::RobotControl& control, int robots);

// Fills the response: the errors and, for each robot with an update, whether the ball is in its
// dribbler zone.
void fill_response(const CommandPacket& packet, const std::bitset<kMaxRobots>& dribbler_contact,
                   simulation::RobotControlResponse& response);

}  // namespace autoref::league
