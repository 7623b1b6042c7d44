#include "league/team/robot_control.hpp"

#include <fmt/format.h>

#include "league/simulator/robot_control.hpp"
#include "league/team/team_fault.hpp"

namespace autoref::league {

void add_commands(const simulation::RobotControl& control, const Headings& headings,
                  OutputBuilder& builder) {
  const CommandPacket packet = updates_of(control, kMaxRobots);
  if (!packet.errors.empty()) throw TeamFault(packet.errors.front().message);
  for (const CommandUpdate& update : packet.updates) {
    if (update.motion && std::holds_alternative<WheelSpeeds>(*update.motion)) {
      throw TeamFault(fmt::format(
          "robot {} has a wheel velocity; only local and global velocities can be driven",
          update.robot));
    }
    const Vec2& heading = headings.at(static_cast<std::size_t>(update.robot));
    builder.add_command(update.robot, command_of(update, heading, {}));
  }
}

}  // namespace autoref::league
