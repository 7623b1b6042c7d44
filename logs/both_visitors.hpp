// Two visitors of one game.
#pragma once

#include "league/log_contents.hpp"

namespace autoref::logs {

// Passes everything on to the first and then to the second.
class BothVisitors final : public league::LogVisitor {
 public:
  BothVisitors(league::LogVisitor& first, league::LogVisitor& second)
      : first_(first), second_(second) {}

  void on_frame(const Frame& frame) override {
    first_.on_frame(frame);
    second_.on_frame(frame);
  }
  void on_tracks(const Frame& frame, const Tracks& tracks) override {
    first_.on_tracks(frame, tracks);
    second_.on_tracks(frame, tracks);
  }
  void on_vision(double time_s, const league::VisionPacket& packet) override {
    first_.on_vision(time_s, packet);
    second_.on_vision(time_s, packet);
  }
  void on_referee(double time_s, const league::RefereePacket& packet) override {
    first_.on_referee(time_s, packet);
    second_.on_referee(time_s, packet);
  }

 private:
  league::LogVisitor& first_;
  league::LogVisitor& second_;
};

}  // namespace autoref::logs
