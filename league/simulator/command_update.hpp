// The requests in a packet for a simulator (changes of robot commands, and teleports) and the
// packet's errors.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "league/messages/simulation.pb.h"
#include "soccer/geometry.hpp"
#include "soccer/robot_command.hpp"
#include "soccer/side.hpp"

namespace autoref::league {

// A velocity in the robot's own frame: x forward, y to the left.
struct LocalVelocity {
  Vec2 velocity_mps{0, 0};
  double angular_radps = 0;
};

// A velocity in the coordinates of vision.
struct GlobalVelocity {
  Vec2 velocity_mps{0, 0};
  double angular_radps = 0;
};

// The positions of a robot's wheels: counterclockwise angles from the robot's front, and the
// distance from its centre. The order of the wheels is that of the simulation protocol: front
// right, back right, back left, front left.
struct WheelPositions {
  std::array<double, 4> angles_rad{};
  double distance_m = 0;
};

// Rim speeds of the wheels in the same order as in WheelPositions; positive speeds of all wheels
// turn the robot counterclockwise.
struct WheelSpeeds {
  std::array<double, 4> speeds_mps{};
};

// The velocity that best fits the wheel speeds, by least squares.
LocalVelocity velocity_of(const WheelSpeeds& wheels, const WheelPositions& positions);

// A change of a robot's command. Members that are not set leave the value unchanged.
struct CommandUpdate {
  int robot = 0;
  std::optional<std::variant<LocalVelocity, GlobalVelocity, WheelSpeeds>> motion;
  std::optional<double> kick_speed_mps;  // total speed of the ball after the kick; 0 for no kick
  std::optional<double> kick_angle_rad;  // above the carpet
  std::optional<bool> dribble;
};

// Copies the members that are set in `update` to `held`.
void merge(const CommandUpdate& update, CommandUpdate& held);

// The robot's command. `heading` is the robot's heading in the frame of vision. Members that were
// never set count as zero. A chip kick at another angle than 45 degrees becomes a chip kick at 45
// degrees whose first hop has the same length.
RobotCommand command_of(const CommandUpdate& held, const Vec2& heading,
                        const WheelPositions& wheels);

// A part of a packet that cannot be carried out. Codes are stable; messages are for human readers.
struct PacketError {
  std::string code;
  std::string message;
};

// The contents of a packet with commands.
struct CommandPacket {
  std::vector<CommandUpdate> updates;
  std::vector<PacketError> errors;  // including those for robots that the team does not have
  int absent = 0;                   // number of commands for robots that the team does not have
  std::uint32_t first_absent = 0;   // the first of these robots' numbers; valid if absent > 0
};

// Adds an error for a command to a robot that the team, which has `robots` robots, does not have.
void add_absent(std::uint32_t robot, int robots, CommandPacket& packet);

// The first error other than commands for robots that the team does not have; null without one.
const PacketError* wrong_in(const CommandPacket& packet);

// A request to move the ball, in the coordinates of vision. Members that are not set leave the
// value unchanged.
struct BallTeleport {
  std::optional<double> x_m;
  std::optional<double> y_m;
  std::optional<double> height_m;
  std::optional<double> vx_mps;
  std::optional<double> vy_mps;
  std::optional<double> vertical_mps;
  bool rolls = false;  // the ball rolls immediately instead of sliding first
};

struct RobotTeleport {
  RobotId robot;  // west is yellow
  std::optional<double> x_m;
  std::optional<double> y_m;
  std::optional<double> heading_rad;
  std::optional<double> vx_mps;
  std::optional<double> vy_mps;
  std::optional<double> angular_radps;
  std::optional<bool> is_present;  // whether the robot is on the field
};

using Teleport = std::variant<BallTeleport, RobotTeleport>;

inline constexpr std::size_t kMostErrors = 16;
inline constexpr std::size_t kMostUpdates = 64;  // largest number of updates in one packet

// The error code for a packet that is not of the type that its port expects.
inline constexpr const char* kNotAMessage = "PACKET";

// The error code for a robot that does not exist.
inline constexpr const char* kNoSuchRobot = "ROBOT_ID";

// Whether the packet was of the type that its port expects.
inline bool is_readable(const CommandPacket& packet) {
  for (const PacketError& error : packet.errors)
    if (error.code == kNotAMessage) return false;
  return true;
}

// Adds an error to the list. Errors beyond the first kMostErrors are dropped.
inline void add_error(std::vector<PacketError>& errors, std::string code, std::string message) {
  if (errors.size() < kMostErrors) errors.push_back({std::move(code), std::move(message)});
}

inline void fill_error(const PacketError& error, simulation::SimulatorError& message) {
  message.set_code(error.code);
  message.set_message(error.message);
}

}  // namespace autoref::league
