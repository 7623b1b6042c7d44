// Publishes a game on the league's network: vision, referee and tracker packets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "league/game_packets.hpp"
#include "league/messages/tracker.pb.h"
#include "league/tracker_message.hpp"
#include "runner/game/configuration.hpp"
#include "runner/game/delay_line.hpp"
#include "runner/game/observer.hpp"
#include "runner/live/live_options.hpp"
#include "soccer/tracks.hpp"

namespace autoref::runner {

// Vision is sent as late as the teams' view of the game is (sim.latency_s, whole frames); the times
// in its packets are those of the frames. The referee's packets follow every 25 ms of the game, and
// the tracker's with every frame.
class GamePublisher final : public Observer, league::PacketSink {
 public:
  // `start_unix_s` is the time of the game's first frame in all packets. Throws InputError if the
  // network cannot be used.
  GamePublisher(const GameConfiguration& game, const LiveOptions& options, double start_unix_s);

  void on_other_detections(const OtherDetections& others) override { others_ = others; }
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;

  // Publishes the world while the game waits. The times of later packets are as much later.
  void add_waiting_frame(const sim::WorldState& world, const RefereeSignal& signal);

  // Publishes the tracks of a frame, after on_frame().
  void add(const Tracks& tracks, bool blue_on_positive_half);

  // The serialized detections of the last frame sent.
  const std::vector<std::string>& detections() const { return detections_; }

  // Sends vision to another port from now on.
  void set_vision_port(int port);

  std::int64_t dropped() const;  // datagrams that the system did not take

 private:
  struct Sight {
    Frame frame;
    OtherDetections others;
    bool blue_on_positive_half = true;
  };

  double waited_s() const;
  void on_vision(double time_s, const league::VisionPacket& packet) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;
  template <typename Message>
  void send(const Message& message, DatagramSender& sender);

  LiveOptions options_;
  double start_unix_s_;
  double rate_hz_;
  int latency_frames_;
  league::GamePackets packets_;
  league::TrackerSource source_;
  DatagramSender vision_;
  DatagramSender referee_;
  DatagramSender tracker_;
  OtherDetections others_;
  DelayLine<Sight> sights_;
  double now_s_ = 0;
  std::int64_t next_frame_ = 0;  // of the game
  std::int64_t waited_frames_ = 0;
  league::VisionPacket sent_;
  league::TrackerPacket tracker_packet_;
  std::string bytes_;
  std::vector<std::string> detections_;
};

}  // namespace autoref::runner
