#include "live/simulator/team_ports.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

#include "league/simulator/command_update.hpp"
#include "league/simulator/robot_control.hpp"
#include "league/simulator/sync_request.hpp"
#include "live/simulator/lock_step.hpp"
#include "soccer/side.hpp"

namespace autoref::live {
namespace {

constexpr double kSameLength_m = 0.002;
constexpr std::size_t kControlPort = 2;  // index of a receiver, like kGrsimPort
constexpr std::size_t kGrsimPort = 3;

std::size_t index_of(const Participant& to) {
  return to ? static_cast<std::size_t>(*to) : kControlPort;
}

PerSide<int> robot_counts(const game::GameConfiguration& game) {
  const auto count = [&](Side side) {
    return static_cast<int>(game::team_on(game, side).robots.size());
  };
  return {{count(Side::kWest), count(Side::kEast)}};
}

bool is_same_size(const Field& one, const Field& other) {
  return std::abs(one.length_m - other.length_m) < kSameLength_m &&
         std::abs(one.width_m - other.width_m) < kSameLength_m &&
         std::abs(one.goal_width_m - other.goal_width_m) < kSameLength_m;
}

bool asks(const league::SimulatorRequest& request) {
  return !request.teleports.empty() || request.speed || request.vision_port || request.field ||
         !request.specs.empty();
}

league::CommandPacket refused_packet() {
  league::CommandPacket refused;
  refused.errors = {{"SOURCE", "another computer commands this team"}};
  return refused;
}

std::string response_to(const league::CommandPacket& packet,
                        const std::bitset<kMaxRobots>& contact) {
  simulation::RobotControlResponse response;
  league::fill_response(packet, contact, response);
  return response.SerializeAsString();
}

}  // namespace

PerSide<bool> network_sides(const game::GameConfiguration& game) {
  return {
      {game::team_on(game, Side::kWest).on_network, game::team_on(game, Side::kEast).on_network}};
}

TeamPorts::TeamPorts(NetworkThread& thread, const LiveOptions& options,
                     const game::GameConfiguration& game, const PortTargets& targets)
    : options_(options),
      is_network_(network_sides(game)),
      robots_(robot_counts(game)),
      field_(game.field),
      is_awaited_(game.match.control == referee::Control::kAutoref),
      targets_(targets) {
  if (is_network_[Side::kWest]) listen(thread, Side::kWest, options.ports.yellow, "--yellow-port");
  if (is_network_[Side::kEast]) listen(thread, Side::kEast, options.ports.blue, "--blue-port");
  listen(thread, std::nullopt, options.ports.control, "--control-port");
  if (options.ports.grsim == 0 || (!is_network_[Side::kWest] && !is_network_[Side::kEast])) return;
  receivers_.at(kGrsimPort)
      .emplace(thread,
               DatagramReceiver::Place{options.interface, "", options.ports.grsim, "--grsim-port"},
               [this](std::string_view bytes, const Address& from) {
                 read_grsim(bytes, from);
                 return std::nullopt;
               });
}

void TeamPorts::listen(NetworkThread& thread, const Participant& to, int port, const char* flag) {
  if (port == 0) return;
  const DatagramReceiver::Place place{options_.interface, "", port, flag};
  const auto handler = [this, to](Transport transport) {
    return [this, to, transport](std::string_view bytes, const Address& from) {
      return answer(to, bytes, from, transport);
    };
  };
  receivers_.at(index_of(to)).emplace(thread, place, handler(Transport::kDatagram));
  servers_.at(index_of(to)).emplace(thread, place, handler(Transport::kStream));
}

bool TeamPorts::is_admitted(Side side, const Address& from, bool has_commands) {
  const std::lock_guard lock(mutex_);
  if (sources_[side].admits(from.host, std::chrono::steady_clock::now(), has_commands)) return true;
  ++traffic_[side].foreign;
  return false;
}

bool TeamPorts::commands_from(Side side, const Address& from) const {
  const std::lock_guard lock(mutex_);
  return is_present_[side] && sources_[side].host() == from.host;
}

// Anybody can send garbage, so only commands show that a team is there.
void TeamPorts::count(Side side, league::CommandPacket& packet, const Address& from,
                      bool has_commands) {
  const std::lock_guard lock(mutex_);
  is_present_[side] = is_present_[side] || has_commands;
  if (!is_present_[side] && packet.errors.empty())
    league::add_error(packet.errors, "NO_COMMANDS",
                      "the packet neither commands a robot nor asks for a step");
  ++traffic_[side].packets;
  if (packet.absent > 0) count_absent(side, packet, from);
  if (packet.errors.empty()) return;
  if (const league::PacketError* error = league::wrong_in(packet)) {
    ++traffic_[side].wrong;
    traffic_[side].last_error =
        fmt::format("{} (from {}:{})", error->message, from.host, from.port);
  }
  if (!is_present_[side]) note_stranger(side, from, packet.errors.front().message);
}

// Must be called with the lock held.
void TeamPorts::count_absent(Side side, const league::CommandPacket& packet, const Address& from) {
  TeamTraffic& traffic = traffic_[side];
  traffic.absent += packet.absent;
  if (!is_present_[side] || !traffic.first_absent.empty()) return;
  traffic.first_absent =
      fmt::format("robot {}, from {}:{}", packet.first_absent, from.host, from.port);
  notices_.push_back(fmt::format(
      "{} has no robot {}, but {}:{} commands it; such commands are ignored and counted",
      colour_of(side), packet.first_absent, from.host, from.port));
}

void TeamPorts::count_wrong_control() {
  const std::lock_guard lock(mutex_);
  ++wrong_control_;
}

// Must be called with the lock held.
void TeamPorts::note_stranger(Side side, const Address& from, const std::string& error) {
  if (std::exchange(is_noted_[side], true)) return;
  const std::string what =
      is_awaited_ ? fmt::format("does not start the game: {}; still waiting for {}", error,
                                targets_.lock_step == nullptr ? "commands" : "a request for a step")
                  : fmt::format("commands no robot: {}", error);
  notices_.push_back(
      fmt::format("a packet for {} from {}:{} {}", colour_of(side), from.host, from.port, what));
}

std::vector<std::string> TeamPorts::take_notices() {
  const std::lock_guard lock(mutex_);
  return std::exchange(notices_, {});
}

void TeamPorts::take_over(Side side, const league::CommandPacket& packet) {
  {
    const std::lock_guard lock(mutex_);
    if (!is_present_[side] || !league::is_readable(packet)) return;
  }
  targets_.slots->add(side, packet.updates);
}

std::optional<std::string> TeamPorts::answer(const Participant& to, std::string_view bytes,
                                             const Address& from, Transport transport) {
  if (league::is_sync_request(bytes)) return answer_sync_request(to, bytes, from, transport);
  return to ? answer_team(*to, bytes, from) : answer_control(bytes);
}

std::string TeamPorts::answer_team(Side side, std::string_view bytes, const Address& from) {
  league::CommandPacket packet;
  if (targets_.lock_step == nullptr) {
    packet = league::read_robot_control(bytes, robots_[side]);
  } else {
    packet.errors = {{"LOCK_STEP", "this game only accepts SimulationSyncRequests"}};
  }
  const bool has_commands = !packet.updates.empty();
  if (!is_admitted(side, from, has_commands)) return response_to(refused_packet(), {});
  count(side, packet, from, has_commands);
  take_over(side, packet);
  const std::lock_guard lock(mutex_);
  return response_to(packet, reports_[side].ball_contact);
}

std::string TeamPorts::answer_control(std::string_view bytes) {
  league::SimulatorRequest request = league::read_simulator_command(bytes, robots_);
  refuse_unsupported(request, request.errors);
  simulation::SimulatorResponse response;
  for (const league::PacketError& error : request.errors)
    league::fill_error(error, *response.add_errors());
  if (!request.errors.empty()) count_wrong_control();
  if (!targets_.control->add(std::move(request)))
    league::fill_error({"BUSY", "too many commands are waiting for the next frame"},
                       *response.add_errors());
  return response.SerializeAsString();
}

// The scenario sets the field and the robots. In a game without a clock, the teams set the pace.
void TeamPorts::refuse_unsupported(league::SimulatorRequest& request,
                                   std::vector<league::PacketError>& errors) const {
  if (request.field && !is_same_size(*request.field, field_))
    league::add_error(errors, "UNSUPPORTED_GEOMETRY",
                      "the scenario determines the field; set field.* there");
  targets_.robots->add(request.specs, errors);
  if (request.speed && options_.speed.pace != Pace::kClock)
    league::add_error(errors, "UNSUPPORTED_SPEED", "the teams set the pace of this game");
}

std::optional<std::string> TeamPorts::answer_sync_request(const Participant& participant,
                                                          std::string_view bytes,
                                                          const Address& from,
                                                          Transport transport) {
  league::SyncRequest request = league::read_sync_request(bytes, participant, robots_);
  std::vector<league::PacketError>& errors = request.commands.errors;
  const bool is_lock_step = targets_.lock_step != nullptr;
  if (!is_lock_step)
    league::add_error(errors, "NO_LOCK_STEP", "the game was not started with --speed lockstep");
  const bool goes_on = is_lock_step && (request.step_s > 0 || !request.commands.updates.empty());
  if (participant && !is_admitted(*participant, from, goes_on))
    return response_to(refused_packet(), {});
  // Detections are for those in command: nobody else may take them away from a team.
  const bool is_stranger = participant && !goes_on && !commands_from(*participant, from);
  if (!is_lock_step || !request.is_readable || is_stranger) {
    participant ? count(*participant, request.commands, from, false) : count_wrong_control();
    return league::sync_response({}, {{}, errors}, {});
  }
  if (participant && options_.ports.control == 0 && asks(request.control)) {
    league::add_error(errors, "CONTROL_CLOSED", "teams must not control the simulator");
    request.control = {};
  }
  refuse_unsupported(request.control, errors);
  if (participant) count(*participant, request.commands, from, goes_on);
  return add_to_lock_step(participant, std::move(request), from, transport);
}

std::optional<std::string> TeamPorts::add_to_lock_step(const Participant& participant,
                                                       league::SyncRequest request,
                                                       const Address& from, Transport transport) {
  const auto respond = [this, port = index_of(participant), from, transport](std::string reply) {
    if (transport == Transport::kStream)
      servers_.at(port)->send(std::move(reply), from);
    else
      receivers_.at(port)->send(std::move(reply), from);
  };
  const std::size_t longest = transport == Transport::kStream ? kLongestResponse : kLongestSent;
  if (targets_.lock_step->add(participant, std::move(request), respond, longest))
    return std::nullopt;
  return league::sync_response(
      {}, {{}, {{"BUSY", "too many requests are waiting for the next frame"}}}, {});
}

void TeamPorts::read_grsim(std::string_view bytes, const Address& from) {
  league::GrsimPacket packet = league::read_grsim_packet(bytes, robots_);
  const bool has_commands = !packet.commands.updates.empty();
  if (!is_network_[packet.side] || !is_admitted(packet.side, from, has_commands)) return;
  // Robot replacements have no team, so their errors are not attributed to blue.
  const bool only_replaces = !has_commands && !packet.teleports.empty();
  if (!only_replaces) count(packet.side, packet.commands, from, has_commands);
  if (targets_.lock_step == nullptr) take_over(packet.side, packet.commands);
  if (!packet.teleports.empty() && options_.ports.control != 0) {
    league::SimulatorRequest replacement;
    replacement.teleports = packet.teleports;
    targets_.control->add(std::move(replacement));
  }
  if (!has_commands) return;
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

std::int64_t TeamPorts::oversized(std::size_t port) const {
  return receivers_.at(port) ? receivers_.at(port)->oversized() : 0;
}

// Packets at grSim's port that cannot be read count as the yellow team's.
PerSide<TeamTraffic> TeamPorts::traffic() const {
  PerSide<std::int64_t> too_long;
  too_long[Side::kWest] = oversized(index_of(Side::kWest)) + oversized(kGrsimPort);
  too_long[Side::kEast] = oversized(index_of(Side::kEast));
  const std::lock_guard lock(mutex_);
  PerSide<TeamTraffic> traffic = traffic_;
  for (const Side side : kSides) {
    traffic[side].packets += too_long[side];
    traffic[side].wrong += too_long[side];
    if (too_long[side] > 0 && traffic[side].last_error.empty())
      traffic[side].last_error = fmt::format("a packet is longer than {} bytes", kLongestDatagram);
  }
  return traffic;
}

std::int64_t TeamPorts::wrong_control() const {
  const std::lock_guard lock(mutex_);
  return wrong_control_ + oversized(index_of(std::nullopt));
}

StreamTroubles TeamPorts::troubles() const {
  StreamTroubles sum;
  for (const auto& server : servers_) {
    if (!server) continue;
    const StreamTroubles one = server->troubles();
    sum.refused += one.refused;
    sum.invalid += one.invalid;
    sum.unread += one.unread;
  }
  return sum;
}

}  // namespace autoref::live
