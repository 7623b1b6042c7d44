// Collects a log's frames and signals for a page.
#pragma once

#include <string>

#include "league/log_contents.hpp"
#include "runner/view/game_recording.hpp"
#include "soccer/side.hpp"

namespace autoref::runner {

class LogRecorder final : public league::LogVisitor {
 public:
  void on_frame(const Frame& frame) override { recording.add(frame); }
  void on_referee(double time_s, const league::RefereePacket& packet) override;

  GameRecording recording;
  PerSide<std::string> names;  // of the teams, as in the last packet
};

}  // namespace autoref::runner
