#include "runner/live/team_ports.hpp"

#include <cmath>
#include <utility>

#include "league/simulator/packet_errors.hpp"
#include "league/simulator/robot_control.hpp"
#include "league/simulator/sync_request.hpp"
#include "runner/live/lock_step.hpp"

namespace autoref::runner {
namespace {

constexpr std::chrono::seconds kSilence{2};
constexpr std::size_t kMostRequests = 64;
constexpr double kSameLength_m = 0.002;
constexpr std::size_t kWestPort = 0;  // indices of the receivers
constexpr std::size_t kEastPort = 1;
constexpr std::size_t kControlPort = 2;
constexpr std::size_t kGrsimPort = 3;

PerSide<int> robot_counts(const GameConfiguration& game) {
  const auto count = [&](Side side) { return static_cast<int>(team_on(game, side).robots.size()); };
  return {{count(Side::kWest), count(Side::kEast)}};
}

bool is_same_size(const Field& one, const Field& other) {
  return std::abs(one.length_m - other.length_m) < kSameLength_m &&
         std::abs(one.width_m - other.width_m) < kSameLength_m &&
         std::abs(one.goal_width_m - other.goal_width_m) < kSameLength_m;
}

std::string response_to(const league::CommandPacket& packet,
                        const std::bitset<kMaxRobots>& contact) {
  simulation::RobotControlResponse response;
  league::fill_response(packet, contact, response);
  return response.SerializeAsString();
}

}  // namespace

bool SourceLock::admits(const std::string& host, std::chrono::steady_clock::time_point now) {
  if (host != host_ && !host_.empty() && now - last_ < kSilence) return false;
  host_ = host;
  last_ = now;
  return true;
}

bool ControlRequests::add(league::SimulatorRequest request) {
  const std::lock_guard lock(mutex_);
  if (requests_.size() == kMostRequests) return false;
  requests_.push_back(std::move(request));
  return true;
}

std::vector<league::SimulatorRequest> ControlRequests::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(requests_, {});
}

PerSide<bool> network_sides(const GameConfiguration& game) {
  return {{team_on(game, Side::kWest).on_network, team_on(game, Side::kEast).on_network}};
}

TeamPorts::TeamPorts(NetworkThread& thread, const LiveOptions& options,
                     const GameConfiguration& game, const PortTargets& targets)
    : options_(options),
      is_network_(network_sides(game)),
      robots_(robot_counts(game)),
      field_(game.field),
      targets_(targets) {
  const auto listen = [&](std::size_t index, int port, const char* flag,
                          DatagramReceiver::Handler handler) {
    if (port == 0) return;
    receivers_.at(index).emplace(thread, DatagramReceiver::Place{options.interface, "", port, flag},
                                 std::move(handler));
  };
  const auto protocol_of = [this](const Participant& to) {
    return
        [this, to](std::string_view bytes, const Address& from) { return answer(to, bytes, from); };
  };
  if (is_network_[Side::kWest])
    listen(kWestPort, options.ports.yellow, "--yellow-port", protocol_of(Side::kWest));
  if (is_network_[Side::kEast])
    listen(kEastPort, options.ports.blue, "--blue-port", protocol_of(Side::kEast));
  listen(kControlPort, options.ports.control, "--control-port", protocol_of(std::nullopt));
  if (!is_network_[Side::kWest] && !is_network_[Side::kEast]) return;
  listen(kGrsimPort, options.ports.grsim, "--grsim-port",
         [this](std::string_view bytes, const Address& from) {
           read_grsim(bytes, from);
           return std::string();
         });
}

bool TeamPorts::is_admitted(Side side, const Address& from) {
  const std::lock_guard lock(mutex_);
  if (sources_[side].admits(from.host, std::chrono::steady_clock::now())) return true;
  ++traffic_[side].foreign;
  return false;
}

void TeamPorts::count(Side side, const league::CommandPacket& packet) {
  const std::lock_guard lock(mutex_);
  ++traffic_[side].packets;
  if (packet.errors.empty()) return;
  ++traffic_[side].wrong;
  traffic_[side].last_error = packet.errors.front().message;
}

std::string TeamPorts::answer(const Participant& to, std::string_view bytes, const Address& from) {
  if (to && !is_admitted(*to, from)) {
    league::CommandPacket refused;
    refused.errors = {{"SOURCE", "another computer commands this team"}};
    return response_to(refused, {});
  }
  if (league::is_sync_request(bytes) && targets_.lock_step != nullptr) {
    begin_step(to, bytes, from);
    return {};
  }
  return to ? answer_team(*to, bytes) : answer_control(bytes);
}

std::string TeamPorts::answer_team(Side side, std::string_view bytes) {
  league::CommandPacket packet;
  if (targets_.lock_step == nullptr) {
    packet = league::read_robot_control(bytes, robots_[side]);
  } else {
    packet.errors = {{"LOCK_STEP", "the game is played by SimulationSyncRequests"}};
  }
  count(side, packet);
  targets_.slots->add(side, packet.updates);
  const std::lock_guard lock(mutex_);
  return response_to(packet, reports_[side].ball_contact);
}

std::string TeamPorts::answer_control(std::string_view bytes) {
  league::SimulatorRequest request = league::read_simulator_command(bytes, robots_);
  refuse_other_game(request);
  simulation::SimulatorResponse response;
  for (const league::PacketError& error : request.errors)
    league::fill_error(error, *response.add_errors());
  if (!targets_.control->add(std::move(request)))
    league::fill_error({"BUSY", "too many commands wait for the next frame"},
                       *response.add_errors());
  return response.SerializeAsString();
}

// The field and the robots are the scenario's.
void TeamPorts::refuse_other_game(league::SimulatorRequest& request) const {
  if (request.field && !is_same_size(*request.field, field_))
    league::add_error(request.errors, "UNSUPPORTED_GEOMETRY",
                      "the scenario determines the field; set field.* there");
  if (!request.specs.empty())
    league::add_error(request.errors, "UNSUPPORTED_SPECS",
                      "the scenario determines the robots; set sim.robot.* there");
}

void TeamPorts::begin_step(const Participant& participant, std::string_view bytes,
                           const Address& from) {
  league::SyncRequest request = league::read_sync_request(bytes, participant, robots_);
  if (participant) count(*participant, request.commands);
  const std::size_t port = participant ? static_cast<std::size_t>(*participant) : kControlPort;
  targets_.lock_step->add(participant, std::move(request), [this, port, from](std::string reply) {
    receivers_.at(port)->send(std::move(reply), from);
  });
}

void TeamPorts::read_grsim(std::string_view bytes, const Address& from) {
  const league::GrsimPacket packet = league::read_grsim_packet(bytes, robots_);
  if (!is_network_[packet.side] || !is_admitted(packet.side, from)) return;
  count(packet.side, packet.commands);
  if (targets_.lock_step == nullptr) targets_.slots->add(packet.side, packet.commands.updates);
  if (!packet.teleports.empty() && options_.ports.control != 0) {
    league::SimulatorRequest replacement;
    replacement.teleports = packet.teleports;
    targets_.control->add(std::move(replacement));
  }
  const std::lock_guard lock(mutex_);
  grsim_hosts_[packet.side] = from.host;
}

void TeamPorts::report(const PerSide<RobotReports>& reports) {
  PerSide<std::string> hosts;
  {
    const std::lock_guard lock(mutex_);
    reports_ = reports;
    hosts = grsim_hosts_;
  }
  for (const Side side : kSides) {
    if (hosts[side].empty()) continue;
    if (hosts[side] != status_hosts_[side]) {
      const int port = side == Side::kWest ? options_.ports.grsim_status_yellow
                                           : options_.ports.grsim_status_blue;
      status_senders_[side].emplace(options_.interface, Address{hosts[side], port});
      status_hosts_[side] = hosts[side];
    }
    send_status(side, reports[side]);
  }
}

void TeamPorts::send_status(Side side, const RobotReports& reports) {
  grsim::RobotsStatus message;
  for (int number = 0; number < robots_[side]; ++number) {
    const league::GrsimStatus& status = reports.status.at(static_cast<std::size_t>(number));
    if (status == sent_[side].status.at(static_cast<std::size_t>(number))) continue;
    league::add_status(number, status, message);
  }
  sent_[side] = reports;
  if (message.robots_status_size() > 0) status_senders_[side]->send(message.SerializeAsString());
}

PerSide<TeamTraffic> TeamPorts::traffic() const {
  const std::lock_guard lock(mutex_);
  return traffic_;
}

}  // namespace autoref::runner
