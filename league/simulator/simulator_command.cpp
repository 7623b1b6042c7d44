#include "league/simulator/simulator_command.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "league/field_message.hpp"
#include "league/message_fields.hpp"
#include "league/simulator/command_update.hpp"
#include "soccer/side.hpp"

namespace autoref::league {
namespace {

constexpr double kFarthest = 100;  // largest magnitude in a teleport, in m, m/s or rad/s
constexpr double kLargestSpec = 1000;
constexpr int kHighestPort = 65535;

std::optional<RobotId> id_of(const simulation::SimulatedRobotId& id, const PerSide<int>& robots) {
  if (id.team() != kYellowTeam && id.team() != kBlueTeam) return std::nullopt;
  const Side side = id.team() == kYellowTeam ? Side::kWest : Side::kEast;
  if (!id.has_id() || id.id() >= static_cast<std::uint32_t>(robots[side])) return std::nullopt;
  return RobotId{side, static_cast<int>(id.id())};
}

// Copies a value if it is set. Returns false if the value is impossible.
bool read_number(bool is_set, float value, double limit, std::optional<double>& number) {
  if (!is_set) return true;
  number = static_cast<double>(value);
  return std::abs(*number) <= limit;
}

bool take_positive(bool is_set, float value, std::optional<double>& number) {
  return read_number(is_set, value, kLargestSpec, number) && (!is_set || *number > 0);
}

bool read_ball(const simulation::TeleportBall& message, BallTeleport& ball) {
  ball.rolls = message.roll();
  return read_number(message.has_x(), message.x(), kFarthest, ball.x_m) &&
         read_number(message.has_y(), message.y(), kFarthest, ball.y_m) &&
         read_number(message.has_z(), message.z(), kFarthest, ball.height_m) &&
         read_number(message.has_vx(), message.vx(), kFarthest, ball.vx_mps) &&
         read_number(message.has_vy(), message.vy(), kFarthest, ball.vy_mps) &&
         read_number(message.has_vz(), message.vz(), kFarthest, ball.vertical_mps);
}

bool read_robot(const simulation::TeleportRobot& message, RobotTeleport& robot) {
  if (message.has_present()) robot.is_present = message.present();
  return read_number(message.has_x(), message.x(), kFarthest, robot.x_m) &&
         read_number(message.has_y(), message.y(), kFarthest, robot.y_m) &&
         read_number(message.has_orientation(), message.orientation(), kFarthest,
                     robot.heading_rad) &&
         read_number(message.has_v_x(), message.v_x(), kFarthest, robot.vx_mps) &&
         read_number(message.has_v_y(), message.v_y(), kFarthest, robot.vy_mps) &&
         read_number(message.has_v_angular(), message.v_angular(), kFarthest, robot.angular_radps);
}

bool read_specs(const simulation::RobotSpecs& message, SpecUpdate& spec) {
  const simulation::RobotLimits& limits = message.limits();
  return take_positive(message.has_mass(), message.mass(), spec.mass_kg) &&
         take_positive(message.has_max_linear_kick_speed(), message.max_linear_kick_speed(),
                       spec.kick_limit_mps) &&
         take_positive(message.has_max_chip_kick_speed(), message.max_chip_kick_speed(),
                       spec.chip_limit_mps) &&
         take_positive(limits.has_acc_speedup_absolute_max(), limits.acc_speedup_absolute_max(),
                       spec.acceleration_mps2) &&
         take_positive(limits.has_acc_speedup_angular_max(), limits.acc_speedup_angular_max(),
                       spec.angular_acceleration_radps2) &&
         take_positive(limits.has_acc_brake_absolute_max(), limits.acc_brake_absolute_max(),
                       spec.braking_mps2) &&
         take_positive(limits.has_vel_absolute_max(), limits.vel_absolute_max(), spec.speed_mps) &&
         take_positive(limits.has_vel_angular_max(), limits.vel_angular_max(),
                       spec.angular_speed_radps);
}

class RequestReader {
 public:
  explicit RequestReader(const PerSide<int>& robots) : robots_(robots) {}

  void read(const simulation::SimulatorCommand& command) {
    if (command.has_control()) read(command.control());
    if (command.has_config()) read(command.config());
  }

  void refuse(const char* code, std::string message) {
    add_error(request_.errors, code, std::move(message));
  }

  SimulatorRequest request() && { return std::move(request_); }

 private:
  void read(const simulation::SimulatorControl& control) {
    if (control.has_teleport_ball()) {
      BallTeleport ball;
      if (read_ball(control.teleport_ball(), ball)) {
        request_.teleports.emplace_back(ball);
      } else {
        refuse("TELEPORT", "the teleport command for the ball contains an invalid number");
      }
    }
    for (const simulation::TeleportRobot& message : control.teleport_robot()) read(message);
    if (!control.has_simulation_speed()) return;
    const double speed = static_cast<double>(control.simulation_speed());
    // As a float, a value may be slightly less than its decimal value.
    const bool is_slow = speed < static_cast<double>(static_cast<float>(kSlowestSimulation));
    if (speed == 0 || (!is_slow && speed <= kFastestSimulation)) {
      request_.speed = speed;
    } else {
      refuse("SPEED", fmt::format("simulation_speed is {}; it must be from {} to {}, or 0 to pause",
                                  speed, kSlowestSimulation, kFastestSimulation));
    }
  }

  void read(const simulation::TeleportRobot& message) {
    if (request_.teleports.size() == kMostUpdates) return;
    const std::optional<RobotId> robot = known(message.id());
    if (!robot) return;
    RobotTeleport teleport;
    teleport.robot = *robot;
    if (!read_robot(message, teleport))
      return refuse("TELEPORT",
                    fmt::format("the teleport command for {} robot {} contains an invalid number",
                                colour_of(robot->side), robot->number));
    request_.teleports.emplace_back(teleport);
  }

  void read(const simulation::SimulatorConfig& config) {
    if (config.has_geometry()) read_geometry(config.geometry());
    for (const simulation::RobotSpecs& specs : config.robot_specs()) read(specs);
    if (config.has_realism_config() && config.realism_config().custom_size() > 0)
      refuse("UNSUPPORTED_REALISM", "the scenario's settings sim.* determine the realism");
    if (!config.has_vision_port()) return;
    if (config.vision_port() >= 1 && config.vision_port() <= kHighestPort) {
      request_.vision_port = static_cast<int>(config.vision_port());
    } else {
      refuse("VISION_PORT", fmt::format("vision_port is {}", config.vision_port()));
    }
  }

  void read_geometry(const std::string& bytes) {
    Geometry geometry;
    try {
      if (!parse(bytes, geometry)) throw std::invalid_argument("it is incomplete");
      request_.field = field_of(geometry);
    } catch (const std::invalid_argument& error) {
      refuse("GEOMETRY", fmt::format("the geometry cannot be used: {}", error.what()));
    }
  }

  void read(const simulation::RobotSpecs& message) {
    if (request_.specs.size() == kMostUpdates) return;
    const std::optional<RobotId> robot = known(message.id());
    if (!robot) return;
    SpecUpdate spec;
    spec.robot = *robot;
    if (!read_specs(message, spec)) {
      return refuse("ROBOT_SPECS", fmt::format("the specs of {} robot {} contain an invalid number",
                                               colour_of(robot->side), robot->number));
    }
    request_.specs.push_back(spec);
    if (message.has_radius() || message.has_height() || message.has_center_to_dribbler() ||
        message.has_wheel_angles() || message.custom_size() > 0) {
      refuse("UNSUPPORTED_SPECS",
             "radius, height, dribbler, wheel angles and custom specs of robots are fixed");
    }
  }

  std::optional<RobotId> known(const simulation::SimulatedRobotId& id) {
    const std::optional<RobotId> robot = id_of(id, robots_);
    if (!robot)
      refuse(kNoSuchRobot, fmt::format("unknown robot {} of team {}", id.id(), id.team()));
    return robot;
  }

  const PerSide<int>& robots_;
  SimulatorRequest request_;
};

}  // namespace

SimulatorRequest request_of(const simulation::SimulatorCommand& command,
                            const PerSide<int>& robots) {
  RequestReader reader(robots);
  reader.read(command);
  return std::move(reader).request();
}

SimulatorRequest read_simulator_command(std::string_view bytes, const PerSide<int>& robots) {
  simulation::SimulatorCommand command;
  if (parse(bytes, command)) return request_of(command, robots);
  RequestReader reader(robots);
  reader.refuse("PACKET",
                fmt::format("a packet of {} bytes is not a SimulatorCommand", bytes.size()));
  return std::move(reader).request();
}

}  // namespace autoref::league
