#include "league/game_packets.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "league/field_message.hpp"
#include "league/message_fields.hpp"
#include "league/vision_message.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::league {
namespace {

constexpr std::size_t kMostGameEvents = 8;
constexpr double kRounding_s = 1e-9;  // rounding error of times that are multiples of a frame

bool puts_play_on(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

}  // namespace

GamePackets::GamePackets(const Field& field, std::vector<CameraPosition> cameras,
                         PerSide<LoggedTeam> teams, const PacketTimes& times)
    : cameras_(std::move(cameras)),
      teams_(std::move(teams)),
      times_(times),
      packets_(cameras_.size()),
      by_capture_(cameras_.size()) {
  std::iota(by_capture_.begin(), by_capture_.end(), std::size_t{0});
  std::stable_sort(by_capture_.begin(), by_capture_.end(), [this](std::size_t a, std::size_t b) {
    return cameras_[a].age_s > cameras_[b].age_s;
  });
  fill_geometry(field, cameras_, *geometry_.mutable_geometry());
  geometry_.set_source(kOtherSource);
}

void GamePackets::note(Command command) {
  sent_.push_back(command);
  if (puts_play_on(command.kind)) events_.clear();
}

void GamePackets::note(GameEvent event) {
  ++noted_events_;
  if (event.id.empty()) event.id = std::to_string(noted_events_);
  if (events_.size() == kMostGameEvents) events_.erase(events_.begin());
  events_.push_back(std::move(event));
  has_new_events_ = true;
}

// The comparison ignores the clock.
bool GamePackets::has_changed(const RefereeSignal& signal) const {
  return referee_.command_counter() != signal.command_counter ||
         referee_.stage() != static_cast<int>(signal.stage) ||
         referee_.has_designated_position() != signal.placement.has_value() ||
         referee_.has_next_command() != signal.next_command.has_value() ||
         referee_.blue_team_on_positive_half() != signal.blue_on_positive_half;
}

void GamePackets::add(const Frame& frame, const RefereeSignal& signal, PacketSink& sink) {
  add_vision(frame, others_, signal.blue_on_positive_half, sink);
  if (!others_.is_empty()) others_ = {};
  add_referee(signal, frame.time_s, sink);
}

void GamePackets::add_vision(const Frame& frame, const OtherDetections& others,
                             bool blue_on_positive_half, PacketSink& sink) {
  if (frame.time_s >= geometry_due_s_) {
    sink.on_vision(std::max(0.0, frame.time_s - cameras_[by_capture_.front()].age_s), geometry_);
    geometry_due_s_ = frame.time_s + times_.geometry_every_s;
  }
  Frame seen = published(frame, blue_on_positive_half);
  seen.time_s += times_.start_s;
  fill_detections(seen, cameras_, packets_, published(others, blue_on_positive_half));
  for (const std::size_t camera : by_capture_)
    sink.on_vision(std::max(0.0, frame.time_s - cameras_[camera].age_s), packets_[camera]);
}

void GamePackets::add_referee(const RefereeSignal& signal, double time_s, PacketSink& sink) {
  send_commands_before(signal, time_s, sink);
  const bool is_due = time_s >= referee_due_s_ - kRounding_s;
  if (is_due) {
    // After a longer silence, the packet interval starts again from this frame.
    if (time_s - referee_due_s_ > times_.referee_every_s) referee_due_s_ = time_s;
    referee_due_s_ += times_.referee_every_s;
  }
  if (is_due || has_changed(signal) || has_new_events_) send_signal(signal, time_s, sink);
}

// Sends the commands that were superseded by another command within the same frame.
void GamePackets::send_commands_before(const RefereeSignal& signal, double time_s,
                                       PacketSink& sink) {
  RefereeSignal before = signal;
  for (std::size_t i = 0; i + 1 < sent_.size(); ++i) {
    before.command = sent_[i];
    // Every command increments the counter.
    before.command_counter =
        signal.command_counter - static_cast<std::uint32_t>(sent_.size() - 1 - i);
    before.stage = static_cast<Stage>(referee_.stage());
    send_signal(before, time_s, sink);
  }
  sent_.clear();
}

// Omits the oldest events if the packet would become too long.
void GamePackets::add_events() {
  const auto add = [this](const GameEvent& event) { return add_game_event(event, referee_); };
  while (!std::all_of(events_.begin(), events_.end(), add)) {
    referee_.clear_game_events();
    events_.erase(events_.begin());
  }
  has_new_events_ = false;
}

void GamePackets::send_signal(const RefereeSignal& signal, double time_s, PacketSink& sink) {
  RefereeSignal shown = published(signal);
  shown.command_time_s += times_.start_s;
  fill_referee(shown, teams_, time_s + times_.start_s, referee_);
  add_events();
  sink.on_referee(time_s, referee_);
}

GameLog::GameLog(const std::filesystem::path& path, const Field& field,
                 std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams)
    : file_(path), packets_(field, std::move(cameras), std::move(teams), {}) {}

template <typename Message>
void GameLog::write(double time_s, MessageKind kind, const Message& message) {
  message.SerializeToString(&bytes_);
  file_.write(to_ns(time_s), kind, bytes_);
}

void GameLog::on_vision(double time_s, const VisionPacket& packet) {
  write(time_s, MessageKind::kVision2014, packet);
}

void GameLog::on_referee(double time_s, const RefereePacket& packet) {
  write(time_s, MessageKind::kReferee2013, packet);
}

}  // namespace autoref::league
