#include "logs/log_page.hpp"

#include <fmt/format.h>

#include "io/build_id.hpp"
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

std::vector<view::ComparedCall> compared_calls(const Agreement& agreement) {
  std::vector<view::ComparedCall> calls;
  calls.reserve(agreement.pairs.size());
  for (const CallPair& pair : agreement.pairs) {
    calls.push_back({pair.recorded ? pair.recorded->stop_s : pair.refereed->stop_s,
                     pair.recorded ? title_of(*pair.recorded) : "",
                     pair.refereed ? title_of(*pair.refereed) : "",
                     other_referee_text(pair, agreement),
                     pair.refereed ? std::optional(pair.refereed->stop_s) : std::nullopt});
  }
  return calls;
}

std::string log_page(const std::filesystem::path& log, const std::string& name, const Field& field,
                     const view::GameRecording& recording,
                     const std::optional<view::ChainKinds>& chain_kinds, const Agreement& agreement,
                     league::FrameSource source) {
  LogRecorder recorder;
  recorder.recording = recording;
  league::read_log(log, recorder, source);
  return view::page_of({recorder.recording,
                        field,
                        recorder.names,
                        {{"log", std::filesystem::path(name).filename().string()},
                         {"right", fmt::format("{} of {} calls; recorded {}", agreement.right,
                                               agreement.refereed, agreement.recorded)},
                         {"page made by build", std::string(io::build_id())}},
                        compared_calls(agreement),
                        chain_kinds});
}

std::string moment_in(const std::string& page, double time_s) {
  return fmt::format("{}#t={:.2f}", page, time_s);
}

}  // namespace autoref::logs
