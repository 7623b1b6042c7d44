#include "logs/log_recorder.hpp"

#include "league/referee_message.hpp"

namespace autoref::logs {

void LogRecorder::on_frame(const Frame& frame) {
  if (!part_.contains(frame.time_s)) return;
  add_signal_before();
  recording.add(frame);
}

void LogRecorder::on_referee(double time_s, const league::RefereePacket& packet) {
  names = {{packet.yellow().name(), packet.blue().name()}};
  const auto signal = league::signal_of(packet);
  if (!signal) return;
  if (time_s < part_.from_s) {
    before_ = *signal;
  } else if (time_s <= part_.to_s) {
    add_signal_before();
    recording.add(time_s, *signal);
  }
}

void LogRecorder::add_signal_before() {
  if (before_) recording.add(part_.from_s, *before_);
  before_.reset();
}

}  // namespace autoref::logs
