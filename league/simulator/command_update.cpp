#include "league/simulator/command_update.hpp"

#include <fmt/format.h>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "soccer/trigonometry.hpp"

namespace autoref::league {
namespace {

struct ToLocal {
  const Vec2& heading;
  const WheelPositions& wheels;
  LocalVelocity operator()(const LocalVelocity& velocity) const { return velocity; }
  LocalVelocity operator()(const GlobalVelocity& velocity) const {
    return {to_local(velocity.velocity_mps, heading), velocity.angular_radps};
  }
  LocalVelocity operator()(const WheelSpeeds& speeds) const { return velocity_of(speeds, wheels); }
};

// The length of a hop is proportional to the product of the speeds over ground and upwards; at 45
// degrees, these are equal.
double ground_speed_mps(double speed_mps, double angle_rad) {
  const SinCos angle = sin_cos(angle_rad);
  return speed_mps * std::sqrt(std::max(0.0, angle.sin * angle.cos));
}

}  // namespace

LocalVelocity velocity_of(const WheelSpeeds& wheels, const WheelPositions& positions) {
  Eigen::Matrix<double, 4, 3> rims;  // maps the robot's velocity to the speeds of the wheels
  Eigen::Vector4d speeds;
  for (std::size_t i = 0; i < 4; ++i) {
    const SinCos angle = sin_cos(positions.angles_rad.at(i));
    const auto row = static_cast<Eigen::Index>(i);
    rims.row(row) << -angle.sin, angle.cos, positions.distance_m;
    speeds(row) = wheels.speeds_mps.at(i);
  }
  const Eigen::Matrix3d normal = rims.transpose() * rims;
  const Eigen::Vector3d velocity = normal.ldlt().solve(rims.transpose() * speeds);
  return {Vec2(velocity.x(), velocity.y()), velocity.z()};
}

void merge(const CommandUpdate& update, CommandUpdate& held) {
  held.robot = update.robot;
  if (update.motion) held.motion = update.motion;
  if (update.kick_speed_mps) held.kick_speed_mps = update.kick_speed_mps;
  if (update.kick_angle_rad) held.kick_angle_rad = update.kick_angle_rad;
  if (update.dribble) held.dribble = update.dribble;
}

RobotCommand command_of(const CommandUpdate& held, const Vec2& heading,
                        const WheelPositions& wheels) {
  RobotCommand command;
  if (held.motion) {
    const LocalVelocity velocity = std::visit(ToLocal{heading, wheels}, *held.motion);
    command.velocity_mps = velocity.velocity_mps;
    command.angular_velocity_radps = velocity.angular_radps;
  }
  const double angle_rad = held.kick_angle_rad.value_or(0);
  const double speed_mps = held.kick_speed_mps.value_or(0);
  command.chip = angle_rad > 0;
  command.kick_mps = command.chip ? ground_speed_mps(speed_mps, angle_rad) : speed_mps;
  command.dribble = held.dribble.value_or(false);
  return command;
}

void add_absent(std::uint32_t robot, int robots, CommandPacket& packet) {
  if (packet.absent++ == 0) packet.first_absent = robot;
  add_error(packet.errors, kNoSuchRobot,
            fmt::format("unknown robot {}; the team has {}", robot, robots));
}

const PacketError* wrong_in(const CommandPacket& packet) {
  const auto error = std::find_if(packet.errors.begin(), packet.errors.end(),
                                  [](const PacketError& one) { return one.code != kNoSuchRobot; });
  return error == packet.errors.end() ? nullptr : &*error;
}

}  // namespace autoref::league
