// Publishes a game on the league's network: vision, referee and tracker packets.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "game/loop/delay_line.hpp"
#include "game/loop/game_configuration.hpp"
#include "game/loop/observer.hpp"
#include "league/game_packets.hpp"
#include "league/messages/tracker.pb.h"
#include "league/tracker_message.hpp"
#include "live/live_options.hpp"
#include "sim/camera.hpp"
#include "soccer/tracks.hpp"

namespace autoref::live {

// All packets of a frame are delayed like the teams' view of the game (sim.latency_s, whole
// frames), so that nobody learns of a decision before receiving the frame that led to it. The times
// in the packets are those of the frame. Referee packets follow every 25 ms of the game, and
// tracker packets with every frame. If a game controller commands the game, it sends the referee
// packets instead.
class GamePublisher final : public game::Observer, league::PacketSink {
 public:
  // `start_unix_s` is the time of the game's first frame in all packets. Throws InputError if the
  // network cannot be used.
  GamePublisher(const game::GameConfiguration& game, const LiveOptions& options,
                double start_unix_s);

  void on_other_detections(const OtherDetections& others) override { newest_.others = others; }
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;

  // The Unix time that later packets give for the game's first frame.
  double start_unix_s() const { return start_unix_s_ + waited_s(); }

  // Publishes the world while the game waits. The times of later packets are shifted accordingly.
  void add_waiting_frame(const sim::WorldState& world, const RefereeSignal& signal);

  // Takes the tracks for the frame of the last on_frame() and sends the packets of the frame that
  // is due. Does nothing if there has been no new frame.
  void publish(const Tracks& tracks);

  // Used in lock-step before the game: publishes the geometry and the signal for programs that wait
  // for them. The content of these packets does not depend on how long the programs wait.
  void send_standing_field(const RefereeSignal& signal);
  // Sends the geometry and the signal again. Does nothing once the first frame has been published.
  void repeat_standing_field();

  // The serialized detections of the last frame sent.
  const std::vector<std::string>& detections() const { return detections_; }

  // Sends vision packets to another port from now on.
  void set_vision_port(int port);

  std::int64_t dropped() const;  // datagrams that the system did not accept

 private:
  struct PublishedFrame {
    Frame frame;
    OtherDetections others;
    Tracks tracks;
    RefereeSignal signal;
    std::vector<Command> commands;
    std::vector<GameEvent> events;
  };

  double waited_s() const;
  void send(const PublishedFrame& due);
  void send_referee(RefereeSignal signal, double time_s);
  void on_vision(double time_s, const league::VisionPacket& packet) override;
  void on_referee(double time_s, const league::RefereePacket& packet) override;
  template <typename Message>
  void send(const Message& message, DatagramSender& sender);

  LiveOptions options_;
  bool sends_signal_;
  double start_unix_s_;
  double rate_hz_;
  int latency_frames_;
  league::GamePackets packets_;
  league::TrackerSource source_;
  DatagramSender vision_;
  DatagramSender referee_;
  DatagramSender tracker_;
  std::string standing_geometry_;  // empty once the game has begun
  std::string standing_signal_;
  PublishedFrame newest_;
  bool has_newest_ = false;
  game::DelayLine<PublishedFrame> frames_;
  sim::Camera waiting_camera_;      // the game's camera sees only the game's frames
  std::int64_t next_number_ = 0;    // frame number in the packets
  std::int64_t waited_frames_ = 0;  // number of frames sent while the game waited
  std::uint32_t command_counter_ = 0;
  double command_waited_s_ = 0;  // how long the game had waited when the command was sent
  league::VisionPacket sent_;
  league::TrackerPacket tracker_packet_;
  std::string bytes_;
  std::vector<std::string> detections_;
};

}  // namespace autoref::live
