#include "league/team/robot_control.hpp"

#include <fmt/format.h>

#include "league/team/team_fault.hpp"

namespace autoref::league {
namespace {

void set_motion(const simulation::RobotCommand& message, const Headings& headings,
                RobotCommand& command) {
  const simulation::RobotMoveCommand& move = message.move_command();
  if (move.has_wheel_velocity()) {
    throw TeamFault(
        fmt::format("robot {} has a wheel velocity; only local and global velocities can be driven",
                    message.id()));
  }
  if (move.has_global_velocity()) {
    const simulation::MoveGlobalVelocity& velocity = move.global_velocity();
    const Vec2 heading = message.id() < kMaxRobots ? headings.at(message.id()) : Vec2(1, 0);
    command.velocity_mps = to_local(Vec2(velocity.x(), velocity.y()), heading);
    command.angular_velocity_radps = velocity.angular();
  } else {
    const simulation::MoveLocalVelocity& velocity = move.local_velocity();
    command.velocity_mps = {velocity.forward(), velocity.left()};
    command.angular_velocity_radps = velocity.angular();
  }
}

bool is_chip(const simulation::RobotCommand& message) {
  const float angle_deg = message.kick_angle();
  if (angle_deg >= 0 && angle_deg <= 90) return angle_deg > 0;
  throw TeamFault(fmt::format("kick_angle of robot {} is {}; it must be from 0 to 90 degrees",
                              message.id(), angle_deg));
}

}  // namespace

void add_commands(const simulation::RobotControl& control, const Headings& headings,
                  OutputBuilder& builder) {
  for (const simulation::RobotCommand& message : control.robot_commands()) {
    RobotCommand command;
    set_motion(message, headings, command);
    command.kick_mps = message.kick_speed();
    command.chip = is_chip(message);
    command.dribble = message.dribbler_speed() > 0;
    builder.add_command(message.id(), command);
  }
}

}  // namespace autoref::league
