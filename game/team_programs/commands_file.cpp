#include "game/team_programs/commands_file.hpp"

#include <algorithm>
#include <bit>

namespace autoref::game {

static_assert(std::endian::native == std::endian::little);

bool is_same(const RobotCommand& a, const RobotCommand& b) {
  return CommandsFormat::numbers_of(a) == CommandsFormat::numbers_of(b) && a.chip == b.chip &&
         a.dribble == b.dribble;
}

bool is_same(const TeamRequests& a, const TeamRequests& b) {
  return a.keeper == b.keeper && a.leaves == b.leaves && a.timeout == b.timeout;
}

std::array<float, 4> CommandsFormat::numbers_of(const RobotCommand& c) {
  return {static_cast<float>(c.velocity_mps.x()), static_cast<float>(c.velocity_mps.y()),
          static_cast<float>(c.angular_velocity_radps), static_cast<float>(c.kick_mps)};
}

std::array<double*, 9> CommandsFormat::limits_of(ChangedRobot& robot) {
  return {&robot.mass_kg,
          &robot.speed_mps,
          &robot.acceleration_mps2,
          &robot.braking_mps2,
          &robot.wheel_acceleration_mps2,
          &robot.angular_speed_radps,
          &robot.angular_acceleration_radps2,
          &robot.kick_limit_mps,
          &robot.chip_limit_mps};
}

bool is_same(const TeamEntry& a, const TeamEntry& b) {
  return is_same(a.requests, b.requests) &&
         std::equal(a.commands.begin(), a.commands.end(), b.commands.begin(),
                    [](const RobotCommand& c, const RobotCommand& d) { return is_same(c, d); });
}

}  // namespace autoref::game
