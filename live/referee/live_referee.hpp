// AutoRef at a real field or with any simulator: it judges the packets on the league's network.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/controller/controller_client.hpp"
#include "live/live_options.hpp"
#include "live/referee/vision_quality.hpp"
#include "logs/recorded_facts.hpp"
#include "referee/decision.hpp"
#include "referee/referee_configuration.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/game_event.hpp"

namespace autoref::live {

struct LiveRefereeOptions {
  std::string interface = kLoopback;
  std::string unicast;  // host to send to instead of the multicast groups
  LivePorts ports;      // ports for vision, referee and tracker packets
  league::FrameSource source = league::FrameSource::kVision;  // kVision or kTracker
  bool commands = false;  // AutoRef commands the game; otherwise it follows the referee packets
  // Where to report game events; an empty host means the sender of the referee packets. If nullopt,
  // AutoRef sends nothing at all unless it commands the game.
  std::optional<Address> controller;
  double seconds = 0;  // time after which to stop; 0: only when interrupted
};

// The status shown to the user.
struct LiveRefereeStatus {
  double time_s = 0;  // time of the last frame
  std::int64_t frames = 0;
  league::MessageFaults faults;
  bool has_referee = false;  // whether packets from another referee arrive
  RefereeSignal signal;
  PerSide<std::string> names;
  VisionReport vision;
  std::optional<ControllerStatus> controller;
};

// Callbacks, called in the thread of run().
struct LiveRefereeCallbacks {
  std::function<void(const referee::Decision& decision)> on_decision;
  // Called with the league's event for a decision or for a successful ball placement.
  std::function<void(const GameEvent& event)> on_game_event;
  // Called after each frame, with the signal in force and positions in the field's coordinates.
  std::function<void(const Frame& frame, const RefereeSignal& signal)> on_frame;
  // Called at least every 50 ms; can throw to stop.
  std::function<void(const LiveRefereeStatus& status)> on_idle;
};

class LiveReferee {
 public:
  // Starts listening. Throws InputError if the network cannot be used.
  explicit LiveReferee(const LiveRefereeOptions& options);
  ~LiveReferee();

  // Waits for the first frames to find out about the field and the teams. Waits for 2 s, or for 10
  // s if no geometry arrives. Meanwhile, calls `check` several times a second with the number of
  // packets received so far; `check` may throw.
  logs::RecordedFacts gather(const std::function<void(std::int64_t packets)>& check);

  // Judges all packets, including those of gather(), until `LiveRefereeOptions::seconds` have
  // passed or on_idle throws. Throws std::invalid_argument if the configuration is not valid.
  void run(const referee::Configuration& configuration, const logs::RecordedFacts& facts,
           const LiveRefereeCallbacks& watch);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace autoref::live
