// The ports at which programs command robots and the simulator: those of the simulation protocol
// and grSim's.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "game/loop/game_configuration.hpp"
#include "league/simulator/command_update.hpp"
#include "league/simulator/grsim_packet.hpp"
#include "live/live_options.hpp"
#include "live/network/network.hpp"
#include "live/network/source_lock.hpp"
#include "live/network/stream_server.hpp"
#include "live/simulator/command_slots.hpp"
#include "live/simulator/control_requests.hpp"
#include "live/simulator/lock_step.hpp"
#include "live/simulator/robot_reports.hpp"
#include "live/simulator/robot_updates.hpp"
#include "soccer/side.hpp"

namespace autoref::live {

// The traffic that has arrived for a team.
struct TeamTraffic {
  std::int64_t packets = 0;  // packets that were read, with or without errors
  std::int64_t wrong = 0;    // number of packets with errors other than absent robots
  std::int64_t absent = 0;   // number of commands for robots that the team does not have
  std::string first_absent;  // the first of these robots, and who commanded it
  // Number of packets dropped because they came from another computer than the team's.
  std::int64_t foreign = 0;
  std::string last_error;  // last error with its sender; empty: none
};

// The objects to which the ports pass their packets.
struct PortTargets {
  CommandSlots* slots = nullptr;
  ControlRequests* control = nullptr;
  RobotUpdates* robots = nullptr;
  LockStep* lock_step = nullptr;  // null: SimulationSyncRequests are errors
};

// How a packet arrived, which is also how its answer is sent.
enum class Transport : std::uint8_t { kDatagram, kStream };

// The sides with teams that play over the network.
PerSide<bool> network_sides(const game::GameConfiguration& game);

class TeamPorts {
 public:
  // Listens at the ports of the game's network teams and at the control port. Accepts datagrams
  // and, except at grSim's port, connections. Throws InputError if a port is in use.
  TeamPorts(NetworkThread& thread, const LiveOptions& options, const game::GameConfiguration& game,
            const PortTargets& targets);

  // Called in the game's thread once per frame: sets the content of the next responses. Sends
  // grSim's status, if it has changed, to teams that command with grSim's packets.
  void report(const PerSide<RobotReports>& reports);

  PerSide<TeamTraffic> traffic() const;
  std::int64_t wrong_control() const;  // packets with errors at the control port

  // Messages for the user since the last call: each reports the first packet at a team's port that
  // commanded no robot while the team had not commanded any yet.
  std::vector<std::string> take_notices();

  // The troubles of all connections.
  StreamTroubles troubles() const;

 private:
  void listen(NetworkThread& thread, const Participant& to, int port, const char* flag);
  std::optional<std::string> answer(const Participant& to, std::string_view bytes,
                                    const Address& from, Transport transport);
  std::string answer_team(Side side, std::string_view bytes, const Address& from);
  std::string answer_control(std::string_view bytes);
  void refuse_unsupported(league::SimulatorRequest& request,
                          std::vector<league::PacketError>& errors) const;
  // Returns nullopt if the reply comes later because the request takes part in the lock-step.
  std::optional<std::string> answer_sync_request(const Participant& participant,
                                                 std::string_view bytes, const Address& from,
                                                 Transport transport);
  std::optional<std::string> add_to_lock_step(const Participant& participant,
                                              league::SyncRequest request, const Address& from,
                                              Transport transport);
  void read_grsim(std::string_view bytes, const Address& from);
  std::int64_t oversized(std::size_t port) const;
  bool is_admitted(Side side, const Address& from, bool has_commands);
  bool commands_from(Side side, const Address& from) const;
  // Counts the packet. Adds an error if it commands no robot and its team has not commanded any
  // yet.
  void count(Side side, league::CommandPacket& packet, const Address& from, bool has_commands);
  void count_absent(Side side, const league::CommandPacket& packet, const Address& from);
  void count_wrong_control();
  void note_stranger(Side side, const Address& from, const std::string& error);
  // Applies the commands; the packet counts as the team's answer to a frame.
  void take_over(Side side, const league::CommandPacket& packet);
  void send_status(Side side, const RobotReports& reports);

  LiveOptions options_;
  PerSide<bool> is_network_;
  PerSide<int> robots_;
  Field field_;
  bool is_awaited_;  // whether the game waits for the teams
  PortTargets targets_;
  mutable std::mutex mutex_;
  PerSide<RobotReports> reports_;
  PerSide<TeamTraffic> traffic_;
  PerSide<bool> is_present_;  // the team has sent commands
  PerSide<bool> is_noted_;    // a packet that commanded no robot has been reported
  std::vector<std::string> notices_;
  std::int64_t wrong_control_ = 0;
  PerSide<SourceLock> sources_;
  PerSide<std::string> grsim_hosts_;  // empty: the team has not sent grSim's packets
  PerSide<std::string> status_hosts_;
  PerSide<std::optional<DatagramSender>> status_senders_;
  PerSide<RobotReports> sent_;
  std::array<std::optional<DatagramReceiver>, 4> receivers_;  // west, east, control, grSim
  std::array<std::optional<StreamServer>, 3> servers_;        // west, east, control
};

}  // namespace autoref::live
