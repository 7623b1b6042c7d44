#include "runner/logs/log_recorder.hpp"

#include "league/referee_message.hpp"

namespace autoref::runner {

void LogRecorder::on_referee(double time_s, const league::RefereePacket& packet) {
  names = {{packet.yellow().name(), packet.blue().name()}};
  if (const auto signal = league::signal_of(packet)) recording.add(time_s, *signal);
}

}  // namespace autoref::runner
