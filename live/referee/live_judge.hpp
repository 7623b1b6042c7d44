// The part of a live referee that judges packets, without sockets.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "league/record_reader.hpp"
#include "live/controller/placement_watch.hpp"
#include "live/referee/live_referee.hpp"
#include "live/referee/referee_outputs.hpp"
#include "live/referee/vision_quality.hpp"
#include "logs/both_visitors.hpp"
#include "logs/record_referee.hpp"

namespace autoref::live {

// A packet of the network.
struct LiveMessage {
  league::ParsedMessage message;
  double time_s = 0;  // since the first packet
  std::string host;   // of the sender
};

class LiveJudge final : league::LogVisitor {
 public:
  // `watch` and `outputs` must outlive the object.
  LiveJudge(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
            bool frames_are_tracked, const LiveRefereeWatch& watch, RefereeOutputs& outputs);

  void take(const LiveMessage& live);

  // Call it often: sends what is due, and calls on_idle every 50 ms.
  void idle();

 private:
  using Clock = std::chrono::steady_clock;

  void on_frame(const Frame& frame) override;  // after the referee has judged it
  void on_vision(double time_s, const league::VisionPacket& packet) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;
  void report(const referee::Decision& decision);
  void report(const GameEvent& event);
  double frame_time_s(Clock::time_point now) const;

  const LiveRefereeWatch& watch_;
  RefereeOutputs& outputs_;
  logs::RecordReferee referee_;
  logs::BothVisitors both_;
  league::RecordReader reader_;
  VisionQuality quality_;
  PlacementWatch placement_;
  LiveRefereeStatus status_;
  Clock::time_point judged_ = Clock::now();
  Clock::time_point idle_due_{};
};

}  // namespace autoref::live
