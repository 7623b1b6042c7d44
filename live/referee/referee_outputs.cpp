#include "live/referee/referee_outputs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "game/loop/game_event.hpp"
#include "live/published_tracks.hpp"
#include "live/referee/live_referee.hpp"

namespace autoref::live {
namespace {

constexpr double kRefereePacketEvery_s = 0.025;
constexpr double kNoGeometry_s = 1e9;  // the field's geometry is vision's to send
constexpr const char* kIdentifier = "AutoRef";

Address destination_of(const LiveRefereeOptions& options, const char* group, int port) {
  return {options.unicast.empty() ? group : options.unicast, port};
}

}  // namespace

RefereeOutputs::RefereeOutputs(const LiveRefereeOptions& options, const Field& field,
                               const PerSide<std::string>& names)
    : commands_(options.commands),
      is_host_known_(options.controller && !options.controller->host.empty()),
      source_{random_uuid(), kIdentifier} {
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
  if (!options.controller) return;
  thread_.emplace();
  controller_.emplace(*thread_, *options.controller, kIdentifier);
}

void RefereeOutputs::set_start(const std::optional<double>& start_unix_s) {
  start_unix_s_ = start_unix_s.value_or(0);
}

void RefereeOutputs::note_referee(const std::string& host) {
  if (!controller_ || is_host_known_ || host == controller_host_) return;
  controller_host_ = host;
  controller_->set_host(host);
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

void RefereeOutputs::report(GameEvent event) {
  if (!controller_) return;
  event.id = fmt::format("{}-{}", source_.uuid, ++reported_);
  controller_->report(event);
}

std::optional<ControllerStatus> RefereeOutputs::controller_status() const {
  return controller_ ? std::optional(controller_->status()) : std::nullopt;
}

}  // namespace autoref::live
