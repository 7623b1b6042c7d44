#include "logs/log_page.hpp"

#include <fmt/format.h>

#include "io/build_id.hpp"
#include "logs/log_recorder.hpp"

namespace autoref::logs {

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
                     const std::vector<view::RecordedDecision>& decisions,
                     const Agreement& agreement, league::FrameSource source) {
  LogRecorder recorder;
  for (const view::RecordedDecision& decision : decisions) recorder.recording.add(decision);
  league::read_log(log, recorder, source);
  return view::page_of({recorder.recording,
                        field,
                        recorder.names,
                        {{"log", std::filesystem::path(name).filename().string()},
                         {"right", fmt::format("{} of {} calls; recorded {}", agreement.right,
                                               agreement.refereed, agreement.recorded)},
                         {"page made by build", std::string(io::build_id())}},
                        compared_calls(agreement)});
}

std::string moment_in(const std::string& page, double time_s) {
  return fmt::format("{}#t={:.2f}", page, time_s);
}

}  // namespace autoref::logs
