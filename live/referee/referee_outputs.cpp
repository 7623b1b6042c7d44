#include "live/referee/referee_outputs.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "game/loop/game_event_fields.hpp"
#include "live/published_tracks.hpp"
#include "live/referee/live_referee.hpp"
#include "logs/user_log.hpp"
#include "soccer/side.hpp"

namespace autoref::live {
namespace {

constexpr double kRefereePacketEvery_s = 0.025;
constexpr double kNoGeometry_s = 1e9;  // vision sends the field's geometry

Address destination_of(const LiveRefereeOptions& options, const char* group, int port) {
  return {options.unicast.empty() ? group : options.unicast, port};
}

std::string clock_of(double time_s) {
  const auto minutes = static_cast<long long>(time_s / 60);
  return fmt::format("{}:{:04.1f}", minutes, time_s - 60.0 * static_cast<double>(minutes));
}

std::string name_or(const std::string& name, const char* colour) {
  return name.empty() ? colour : fmt::format("{} ({})", name, colour);
}

}  // namespace

RefereeOutputs::RefereeOutputs(const LiveRefereeOptions& options, const Field& field,
                               const PerSide<std::string>& names)
    : commands_(options.commands), source_{random_uuid(), kIdentifier} {
  if (commands_) {
    const auto team = [&](Side side) { return league::LoggedTeam{names[side]}; };
    packets_.emplace(field, std::vector<CameraPosition>{},
                     PerSide<league::LoggedTeam>{{team(Side::kWest), team(Side::kEast)}},
                     league::PacketTimes{kNoGeometry_s, kRefereePacketEvery_s, 0});
    referee_.emplace(options.interface,
                     destination_of(options, kRefereeGroup, options.ports.referee));
  }
  const bool sends_tracks = commands_ || options.controller;
  if (sends_tracks && options.source == league::FrameSource::kVision)
    tracker_.emplace(options.interface,
                     destination_of(options, kVisionGroup, options.ports.tracker));
  if (options.controller) controller_.emplace(*options.controller, source_.uuid);
}

void RefereeOutputs::set_start(const std::optional<double>& start_unix_s) {
  start_unix_s_ = start_unix_s.value_or(0);
}

void RefereeOutputs::note_referee(const std::string& host) {
  if (controller_) controller_->note_referee(host);
}

void RefereeOutputs::send_tracks(const Tracks& tracks, bool is_turned) {
  if (!tracker_) return;
  league::fill_tracker(is_turned ? turned(tracks) : tracks, source_, start_unix_s_ + tracks.time_s,
                       tracker_packet_);
  tracker_packet_.SerializeToString(&bytes_);
  tracker_->send(bytes_);
}

void RefereeOutputs::note(const referee::Decision& decision) {
  if (!packets_) return;
  if (decision.command) packets_->note(*decision.command);
  if (std::optional<GameEvent> event = game::game_event_of(decision, start_unix_s_))
    packets_->note(*std::move(event));
}

void RefereeOutputs::send_signal(const RefereeSignal& signal, double time_s) {
  if (!packets_) return;
  latest_s_ = std::max(latest_s_, time_s);  // also if a frame comes late
  packets_->add_referee(signal, latest_s_, *this);
}

void RefereeOutputs::on_referee(double time_s, const league::RefereePacket& packet) {
  league::RefereePacket sent = packet;
  const auto start_us = static_cast<std::uint64_t>(start_unix_s_ * 1e6);
  sent.set_packet_timestamp(static_cast<std::uint64_t>((start_unix_s_ + time_s) * 1e6));
  sent.set_command_timestamp(start_us + packet.command_timestamp());
  sent.SerializeToString(&bytes_);
  referee_->send(bytes_);
}

void RefereeOutputs::report(const GameEvent& event) {
  if (controller_) controller_->report(event);
}

std::optional<ControllerStatus> RefereeOutputs::controller_status() const {
  return controller_ ? std::optional(controller_->status()) : std::nullopt;
}

std::string call_line(const referee::Decision& decision) {
  if (!is_call(decision.finding.event)) return {};
  const std::optional<Side> offender = decision.finding.offender;
  std::string line =
      fmt::format("{}  {}", clock_of(decision.time_s), name_of(decision.finding.event));
  if (offender) line += fmt::format(" {}", colour_of(*offender));
  if (!decision.finding.evidence.empty()) line += ": " + decision.finding.evidence;
  return line;
}

std::string state_line(const LiveRefereeStatus& status) {
  const RefereeSignal& signal = status.signal;
  return fmt::format("{}, {}, {} {} : {} {}", name_of(signal.stage), name_of(signal.command),
                     name_or(status.names[Side::kWest], "yellow"), signal.goals[Side::kWest],
                     signal.goals[Side::kEast], name_or(status.names[Side::kEast], "blue"));
}

std::string status_text(const LiveRefereeStatus& status, const std::deque<std::string>& calls,
                        std::size_t columns) {
  std::string text;
  const auto add = [&](const std::string& line) { text += line.substr(0, columns) + "\n"; };
  add(fmt::format("AutoRef  {}  {} frames", clock_of(status.time_s), status.frames));
  add("Game:    " + state_line(status));
  add("Vision:  " + text_of(status.vision));
  for (const std::string& fault : logs::texts_of(status.faults)) add("         " + fault);
  if (status.controller) add("Controller: " + controller_line(*status.controller));
  add("Calls:");
  for (const std::string& call : calls) add("  " + call);
  return text;
}

}  // namespace autoref::live
