#include "league/simulator/grsim_packet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "league/message_fields.hpp"
#include "league/simulator/command_update.hpp"
#include "league/simulator/robot_control.hpp"
#include "soccer/trigonometry.hpp"
#include "soccer/units.hpp"

namespace autoref::league {
namespace {

constexpr double kLeastUpward_mps = 1e-4;
constexpr double kWheelRadius_m = 0.027;
constexpr double kFarthestTeleport_m = 100;
// grSim's default robot: wheels at 60, 135, 225 and 300 degrees, here in the simulation protocol's
// order.
const WheelPositions kGrsimWheels{
    {to_radians(300), to_radians(225), to_radians(135), to_radians(60)}, 0.09};

bool is_possible_number(double value, double limit) { return std::abs(value) <= limit; }

LocalVelocity motion_of(const grsim::RobotCommand& command) {
  if (!command.wheelsspeed())
    return {Vec2(command.veltangent(), command.velnormal()), command.velangular()};
  return velocity_of(
      WheelSpeeds{{kWheelRadius_m * command.wheel4(), kWheelRadius_m * command.wheel3(),
                   kWheelRadius_m * command.wheel2(), kWheelRadius_m * command.wheel1()}},
      kGrsimWheels);
}

bool is_possible_command(const LocalVelocity& motion, const grsim::RobotCommand& command) {
  return is_possible_number(motion.velocity_mps.x(), kFastestCommand_mps) &&
         is_possible_number(motion.velocity_mps.y(), kFastestCommand_mps) &&
         is_possible_number(motion.angular_radps, kFastestCommand_radps) &&
         is_possible_number(command.kickspeedx(), kFastestCommand_mps) &&
         is_possible_number(command.kickspeedz(), kFastestCommand_mps);
}

void set_kick(const grsim::RobotCommand& command, CommandUpdate& update) {
  const double forward_mps = std::max(0.0, static_cast<double>(command.kickspeedx()));
  const double upward_mps = static_cast<double>(command.kickspeedz());
  const bool is_chip = upward_mps > kLeastUpward_mps;
  update.kick_speed_mps = is_chip ? std::hypot(forward_mps, upward_mps) : forward_mps;
  update.kick_angle_rad = is_chip ? atan2_exact(upward_mps, forward_mps) : 0;
}

void add_grsim(const grsim::RobotCommand& command, int robots, CommandPacket& packet) {
  if (command.id() >= static_cast<std::uint32_t>(robots)) {
    return add_absent(command.id(), robots, packet);
  }
  CommandUpdate update;
  update.robot = static_cast<int>(command.id());
  const LocalVelocity motion = motion_of(command);
  if (!is_possible_command(motion, command)) {
    return add_error(
        packet.errors, "NOT_FINITE",
        fmt::format("the command for robot {} contains an invalid number", update.robot));
  }
  update.motion = motion;
  set_kick(command, update);
  update.dribble = command.spinner();
  packet.updates.push_back(update);
}

std::optional<BallTeleport> ball_of(const grsim::BallReplacement& ball) {
  for (const double value : {ball.x(), ball.y(), ball.vx(), ball.vy()}) {
    if (!is_possible_number(value, kFarthestTeleport_m)) return std::nullopt;
  }
  BallTeleport teleport;
  if (ball.has_x()) teleport.x_m = ball.x();
  if (ball.has_y()) teleport.y_m = ball.y();
  teleport.vx_mps = ball.vx();
  teleport.vy_mps = ball.vy();
  return teleport;
}

std::optional<RobotTeleport> robot_of(const grsim::RobotReplacement& robot,
                                      const PerSide<int>& robots) {
  RobotTeleport teleport;
  teleport.robot.side = robot.yellowteam() ? Side::kWest : Side::kEast;
  if (robot.id() >= static_cast<std::uint32_t>(robots[teleport.robot.side])) return std::nullopt;
  if (!is_possible_number(robot.x(), kFarthestTeleport_m) ||
      !is_possible_number(robot.y(), kFarthestTeleport_m) || !is_possible_number(robot.dir(), 1e6))
    return std::nullopt;
  teleport.robot.number = static_cast<int>(robot.id());
  teleport.x_m = robot.x();
  teleport.y_m = robot.y();
  teleport.heading_rad = to_radians(robot.dir());
  teleport.vx_mps = teleport.vy_mps = teleport.angular_radps = 0;
  if (robot.has_turnon()) teleport.is_present = robot.turnon();
  return teleport;
}

void add_replacement(const grsim::Replacement& replacement, const PerSide<int>& robots,
                     GrsimPacket& packet) {
  const auto refuse = [&](const char* what) {
    add_error(packet.commands.errors, "REPLACEMENT",
              fmt::format("the replacement message for {} is invalid", what));
  };
  if (replacement.has_ball()) {
    if (const auto ball = ball_of(replacement.ball())) {
      packet.teleports.emplace_back(*ball);
    } else {
      refuse("the ball");
    }
  }
  for (const grsim::RobotReplacement& one : replacement.robots()) {
    if (packet.teleports.size() == kMostUpdates) break;
    if (const auto robot = robot_of(one, robots)) {
      packet.teleports.emplace_back(*robot);
    } else {
      refuse("a robot");
    }
  }
}

}  // namespace

GrsimPacket read_grsim_packet(std::string_view bytes, const PerSide<int>& robots) {
  grsim::Packet message;
  GrsimPacket packet;
  const bool is_parsed = parse(bytes, message);
  const bool is_other =
      !message.has_commands() && !message.has_replacement() && !message.unknown_fields().empty();
  if (!is_parsed || is_other) {
    add_error(packet.commands.errors, kNotAMessage,
              fmt::format("a packet of {} bytes is not a grSim_Packet", bytes.size()));
    return packet;
  }
  packet.side = message.commands().isteamyellow() ? Side::kWest : Side::kEast;
  for (const grsim::RobotCommand& command : message.commands().robot_commands()) {
    if (packet.commands.updates.size() == kMostUpdates) break;
    add_grsim(command, robots[packet.side], packet.commands);
  }
  if (message.has_replacement()) add_replacement(message.replacement(), robots, packet);
  return packet;
}

void add_status(int robot, const GrsimStatus& status, grsim::RobotsStatus& message) {
  grsim::RobotStatus& one = *message.add_robots_status();
  one.set_robot_id(robot);
  one.set_infrared(status.infrared);
  one.set_flat_kick(status.flat_kick);
  one.set_chip_kick(status.chip_kick);
}

}  // namespace autoref::league
