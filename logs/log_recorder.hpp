// Collects a log's frames and signals for a page.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "league/log_contents.hpp"
#include "soccer/side.hpp"
#include "view/game_recording.hpp"

namespace autoref::logs {

// The part of a log from one time to another, both included, in seconds on the frames' clock.
struct LogPart {
  double from_s = -std::numeric_limits<double>::infinity();
  double to_s = std::numeric_limits<double>::infinity();

  bool contains(double time_s) const { return time_s >= from_s && time_s <= to_s; }
};

class LogRecorder final : public league::LogVisitor {
 public:
  explicit LogRecorder(LogPart part = {}) : part_(part) {}

  void on_frame(const Frame& frame) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;

  // The frames and signals of the part. Its first signal is the last one before it.
  view::GameRecording recording;
  PerSide<std::string> names;  // of the teams, as in the last packet

 private:
  void add_signal_before();

  LogPart part_;
  std::optional<RefereeSignal> before_;  // the last signal before the part, until it is recorded
};

}  // namespace autoref::logs
