#include "league/game_log.hpp"

#include "league/field_message.hpp"
#include "league/frame_message.hpp"
#include "league/units.hpp"

namespace autoref::league {
namespace {

constexpr double kGeometryEvery_s = 1.0;
constexpr double kRefereeEvery_s = 0.1;

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
         referee_.has_next_command() != signal.next_command.has_value();
}

void GameLog::add(const Frame& frame, const RefereeSignal& signal) {
  if (frame.time_s >= geometry_due_s_) {
    write(frame.time_s, MessageKind::kVision2014, geometry_);
    geometry_due_s_ = frame.time_s + kGeometryEvery_s;
  }
  fill_detections(frame, cameras_, packets_);
  for (const VisionPacket& packet : packets_) write(frame.time_s, MessageKind::kVision2014, packet);
  write_commands_before(signal, frame.time_s);
  if (has_changed(signal) || frame.time_s >= referee_due_s_) write_signal(signal, frame.time_s);
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

void GameLog::write_signal(const RefereeSignal& signal, double time_s) {
  fill_referee(signal, teams_, time_s, referee_);
  write(time_s, MessageKind::kReferee2013, referee_);
  referee_due_s_ = time_s + kRefereeEvery_s;
}

}  // namespace autoref::league
