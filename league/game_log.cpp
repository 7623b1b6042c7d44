#include "league/game_log.hpp"

#include <algorithm>
#include <utility>

#include "league/field_message.hpp"
#include "league/frame_message.hpp"
#include "league/units.hpp"
#include "soccer/published.hpp"

namespace autoref::league {
namespace {

constexpr double kGeometryEvery_s = 1.0;
constexpr double kRefereeEvery_s = 0.1;
constexpr std::size_t kMostGameEvents = 8;

bool puts_play_on(CommandKind kind) {
  return kind == CommandKind::kNormalStart || kind == CommandKind::kForceStart ||
         kind == CommandKind::kDirectFree || kind == CommandKind::kIndirectFree;
}

}  // namespace

GameLog::GameLog(const std::filesystem::path& path, const Field& field,
                 std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams)
    : file_(path),
      cameras_(std::move(cameras)),
      teams_(std::move(teams)),
      packets_(cameras_.size()) {
  fill_geometry(field, cameras_, *geometry_.mutable_geometry());
  geometry_.set_source(kOtherSource);
}

void GameLog::note(Command command) {
  sent_.push_back(command);
  if (puts_play_on(command.kind)) events_.clear();
}

void GameLog::note(GameEvent event) {
  ++noted_events_;
  if (event.id.empty()) event.id = std::to_string(noted_events_);
  if (events_.size() == kMostGameEvents) events_.erase(events_.begin());
  events_.push_back(std::move(event));
  has_new_events_ = true;
}

template <typename Message>
void GameLog::write(double time_s, MessageKind kind, const Message& message) {
  message.SerializeToString(&bytes_);
  file_.write(to_ns(time_s), kind, bytes_);
}

// Ignores the clock.
bool GameLog::has_changed(const RefereeSignal& signal) const {
  return referee_.command_counter() != signal.command_counter ||
         referee_.stage() != static_cast<int>(signal.stage) ||
         referee_.has_designated_position() != signal.placement.has_value() ||
         referee_.has_next_command() != signal.next_command.has_value() ||
         referee_.blue_team_on_positive_half() != signal.blue_on_positive_half;
}

void GameLog::add(const Frame& frame, const RefereeSignal& signal) {
  if (frame.time_s >= geometry_due_s_) {
    write(frame.time_s, MessageKind::kVision2014, geometry_);
    geometry_due_s_ = frame.time_s + kGeometryEvery_s;
  }
  const bool blue_on_positive_half = signal.blue_on_positive_half;
  fill_detections(published(frame, blue_on_positive_half), cameras_, packets_,
                  published(others_, blue_on_positive_half));
  if (!others_.is_empty()) others_ = {};
  for (const VisionPacket& packet : packets_) write(frame.time_s, MessageKind::kVision2014, packet);
  write_commands_before(signal, frame.time_s);
  if (has_changed(signal) || has_new_events_ || frame.time_s >= referee_due_s_)
    write_signal(signal, frame.time_s);
}

// Writes the commands that were superseded by another command within the same frame.
void GameLog::write_commands_before(const RefereeSignal& signal, double time_s) {
  RefereeSignal before = signal;
  for (std::size_t i = 0; i + 1 < sent_.size(); ++i) {
    before.command = sent_[i];
    // Every command increments the counter.
    before.command_counter =
        signal.command_counter - static_cast<std::uint32_t>(sent_.size() - 1 - i);
    before.stage = static_cast<Stage>(referee_.stage());
    write_signal(before, time_s);
  }
  sent_.clear();
}

// Omits the oldest events if the packet would become too long.
void GameLog::add_events() {
  const auto add = [this](const GameEvent& event) { return add_game_event(event, referee_); };
  while (!std::all_of(events_.begin(), events_.end(), add)) {
    referee_.clear_game_events();
    events_.erase(events_.begin());
  }
  has_new_events_ = false;
}

void GameLog::write_signal(const RefereeSignal& signal, double time_s) {
  fill_referee(published(signal), teams_, time_s, referee_);
  add_events();
  write(time_s, MessageKind::kReferee2013, referee_);
  referee_due_s_ = time_s + kRefereeEvery_s;
}

}  // namespace autoref::league
