#include "league/simulator/robot_control.hpp"

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>

#include "league/message_fields.hpp"
#include "league/simulator/command_update.hpp"
#include "soccer/units.hpp"

namespace autoref::league {
namespace {

constexpr double kSteepest_deg = 90;
constexpr double kFastestDribbler_rpm = 1e6;

struct NamedNumber {
  const char* name;
  double value;
  double limit;
};

// Adds an error if a value is beyond its limit or not finite; returns whether all values are
// possible.
bool are_possible(std::initializer_list<NamedNumber> numbers, std::uint32_t robot,
                  CommandPacket& packet) {
  for (const NamedNumber& number : numbers) {
    if (std::abs(number.value) <= number.limit) continue;
    add_error(packet.errors, "NOT_FINITE",
              fmt::format("{} of robot {} is {}; it must be from {} to {}", number.name, robot,
                          number.value, -number.limit, number.limit));
    return false;
  }
  return true;
}

// Sets the motion; returns whether it is possible.
bool set_motion(const simulation::RobotCommand& command, CommandUpdate& update,
                CommandPacket& packet) {
  const simulation::RobotMoveCommand& move = command.move_command();
  if (move.has_wheel_velocity()) {
    const simulation::MoveWheelVelocity& wheels = move.wheel_velocity();
    update.motion = WheelSpeeds{
        {wheels.front_right(), wheels.back_right(), wheels.back_left(), wheels.front_left()}};
    return are_possible({{"front_right", wheels.front_right(), kFastestCommand_mps},
                         {"back_right", wheels.back_right(), kFastestCommand_mps},
                         {"back_left", wheels.back_left(), kFastestCommand_mps},
                         {"front_left", wheels.front_left(), kFastestCommand_mps}},
                        command.id(), packet);
  }
  if (move.has_global_velocity()) {
    const simulation::MoveGlobalVelocity& sent = move.global_velocity();
    update.motion = GlobalVelocity{Vec2(sent.x(), sent.y()), sent.angular()};
    return are_possible({{"x", sent.x(), kFastestCommand_mps},
                         {"y", sent.y(), kFastestCommand_mps},
                         {"angular", sent.angular(), kFastestCommand_radps}},
                        command.id(), packet);
  }
  if (!move.has_local_velocity()) return true;
  const simulation::MoveLocalVelocity& sent = move.local_velocity();
  update.motion = LocalVelocity{Vec2(sent.forward(), sent.left()), sent.angular()};
  return are_possible({{"forward", sent.forward(), kFastestCommand_mps},
                       {"left", sent.left(), kFastestCommand_mps},
                       {"angular", sent.angular(), kFastestCommand_radps}},
                      command.id(), packet);
}

bool is_angle(float angle_deg) { return angle_deg >= 0 && angle_deg <= kSteepest_deg; }

// Adds the update of a command, or an error.
void add(const simulation::RobotCommand& command, int robots, CommandPacket& packet) {
  if (command.id() >= static_cast<std::uint32_t>(robots)) {
    return add_absent(command.id(), robots, packet);
  }
  CommandUpdate update;
  update.robot = static_cast<int>(command.id());
  if (!set_motion(command, update, packet)) return;
  if (!are_possible({{"dribbler_speed", command.dribbler_speed(), kFastestDribbler_rpm}},
                    command.id(), packet))
    return;
  if (!(command.kick_speed() >= 0 && command.kick_speed() <= kFastestCommand_mps)) {
    return add_error(packet.errors, "NOT_FINITE",
                     fmt::format("kick_speed of robot {} is {}; it must be from 0 to {}",
                                 update.robot, command.kick_speed(), kFastestCommand_mps));
  }
  if (!is_angle(command.kick_angle())) {
    return add_error(packet.errors, "ANGLE_VALUE",
                     fmt::format("kick_angle of robot {} is {}; it must be from 0 to 90 degrees",
                                 update.robot, command.kick_angle()));
  }
  if (command.has_kick_speed()) update.kick_speed_mps = command.kick_speed();
  if (command.has_kick_angle()) update.kick_angle_rad = to_radians(command.kick_angle());
  if (command.has_dribbler_speed()) update.dribble = command.dribbler_speed() > 0;
  packet.updates.push_back(update);
}

}  // namespace

CommandPacket updates_of(const simulation::RobotControl& control, int robots) {
  CommandPacket packet;
  for (const simulation::RobotCommand& command : control.robot_commands()) {
    if (packet.updates.size() == kMostUpdates) break;
    add(command, robots, packet);
  }
  return packet;
}

CommandPacket read_robot_control(std::string_view bytes, int robots) {
  simulation::RobotControl control;
  const bool is_parsed = parse(bytes, control);
  const bool is_other = control.robot_commands_size() == 0 && !control.unknown_fields().empty();
  if (is_parsed && !is_other) return updates_of(control, robots);
  CommandPacket packet;
  add_error(packet.errors, kNotAMessage,
            fmt::format("a packet of {} bytes is not a RobotControl", bytes.size()));
  return packet;
}

void fill_response(const CommandPacket& packet, const std::bitset<kMaxRobots>& dribbler_contact,
                   simulation::RobotControlResponse& response) {
  response.Clear();
  for (const PacketError& error : packet.errors) fill_error(error, *response.add_errors());
  for (const CommandUpdate& update : packet.updates) {
    simulation::RobotFeedback& feedback = *response.add_feedback();
    feedback.set_id(static_cast<std::uint32_t>(update.robot));
    feedback.set_dribbler_ball_contact(dribbler_contact[static_cast<std::size_t>(update.robot)]);
  }
}

}  // namespace autoref::league
