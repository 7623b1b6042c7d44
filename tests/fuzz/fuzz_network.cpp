// Fuzzes the packets that programs send to the simulator. The first byte selects the port. Whatever
// is not an error must be finite and within the teams.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "league/simulator/grsim_packet.hpp"
#include "league/simulator/robot_control.hpp"
#include "league/simulator/simulator_command.hpp"
#include "league/simulator/sync_request.hpp"

namespace {

using namespace autoref;
using namespace autoref::league;

const PerSide<int> kTeams{{6, 11}};
const WheelPositions kWheels{{-0.6, -2.4, 2.4, 0.6}, 0.08};

void require(bool holds) {
  if (!holds) std::abort();
}

void check(const CommandPacket& packet, int robots) {
  CommandUpdate held;
  for (const CommandUpdate& update : packet.updates) {
    require(update.robot >= 0 && update.robot < robots);
    merge(update, held);
    require(is_finite(command_of(held, Vec2(0.6, 0.8), kWheels)));
  }
}

void check(const std::vector<Teleport>& teleports) {
  for (const Teleport& teleport : teleports) {
    const auto* robot = std::get_if<RobotTeleport>(&teleport);
    if (robot == nullptr) continue;
    require(robot->robot.number >= 0 && robot->robot.number < kTeams[robot->robot.side]);
    require(std::isfinite(robot->x_m.value_or(0)) && std::isfinite(robot->heading_rad.value_or(0)));
  }
}

void check(const SyncRequest& request) {
  require(std::isfinite(request.step_s));
  check(request.commands, kTeams[Side::kEast]);
  check(request.control.teleports);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 4) {
    case 0:
      check(read_robot_control(bytes, kTeams[Side::kWest]), kTeams[Side::kWest]);
      break;
    case 1: {
      const GrsimPacket packet = read_grsim_packet(bytes, kTeams);
      check(packet.commands, kTeams[packet.side]);
      check(packet.teleports);
      break;
    }
    case 2:
      check(read_simulator_command(bytes, kTeams).teleports);
      break;
    default:
      is_sync_request(bytes);
      check(read_sync_request(bytes, Side::kEast, kTeams));
  }
  return 0;
}
