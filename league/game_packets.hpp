// Turns a game into the packets that its cameras and its referee send, and writes them as an SSL
// log.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "league/field_message.hpp"
#include "league/game_event_message.hpp"
#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "league/messages/vision.pb.h"
#include "league/referee_message.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"
#include "soccer/rules/game_event.hpp"

namespace autoref::league {

// Receives the packets of a game. `time_s` is the time of a vision packet's capture, or of the
// frame; references are valid only during the call.
class PacketSink {
 public:
  virtual ~PacketSink() = default;
  virtual void on_vision(double time_s, const VisionPacket& packet) = 0;
  virtual void on_referee(double time_s, const RefereePacket& packet) = 0;
};

struct PacketTimes {
  double geometry_every_s = 1.0;
  // Average time between two packets; each interval is a whole number of frames.
  double referee_every_s = 0.1;
  double start_s = 0;  // time that the packets give for the game's first frame
};

// Every camera sends one packet per frame, in the order of their captures, in addition to the
// geometry; the referee sends packets regularly and whenever its signal changes. Referee packets
// contain the game events since play was last on, or only the newest ones if all of them would
// exceed kLongestPacket. All packets show each team at its current end (soccer/referee_signal.hpp).
class GamePackets {
 public:
  GamePackets(const Field& field, std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams,
              const PacketTimes& times);

  // Adds the ball model to the geometry.
  void describe(const BallModel& ball) { fill_ball_models(ball, *geometry_.mutable_geometry()); }

  // The packet with the geometry.
  const VisionPacket& geometry() const { return geometry_; }

  // Records a command sent in the next frame. This matters only if several commands are sent in one
  // frame, since the signal contains only the last of them.
  void note(Command command);

  // Adds an event to the referee's packets from the next frame on. An event without an id gets its
  // number as its id.
  void note(GameEvent event);

  // Records what the cameras report in addition to the next frame.
  void note(const OtherDetections& others) { others_ = others; }

  // Passes the packets of a frame to `sink`, vision packets first.
  void add(const Frame& frame, const RefereeSignal& signal, PacketSink& sink);

  // The two parts of add().
  void add_vision(const Frame& frame, const OtherDetections& others, bool blue_on_positive_half,
                  PacketSink& sink);
  void add_referee(const RefereeSignal& signal, double time_s, PacketSink& sink);

 private:
  bool has_changed(const RefereeSignal& signal) const;
  void send_commands_before(const RefereeSignal& signal, double time_s, PacketSink& sink);
  void add_events();
  void send_signal(const RefereeSignal& signal, double time_s, PacketSink& sink);

  std::vector<CameraPosition> cameras_;
  PerSide<LoggedTeam> teams_;
  PacketTimes times_;
  VisionPacket geometry_;
  std::vector<VisionPacket> packets_;    // one per camera
  std::vector<std::size_t> by_capture_;  // the cameras, by the times of their captures
  RefereePacket referee_;                // the last packet sent
  std::vector<Command> sent_;            // commands sent during the current frame
  std::vector<GameEvent> events_;        // events since play was last on
  int noted_events_ = 0;
  bool has_new_events_ = false;
  OtherDetections others_;  // other detections in the current frame
  double geometry_due_s_ = 0;
  double referee_due_s_ = 0;
};

// Writes a game as an SSL log that contains the packets of its cameras and its referee. Times count
// from the game's first frame. The log contains the geometry about once a second, and ten referee
// packets per second plus one whenever the referee's signal changes.
class GameLog final : PacketSink {
 public:
  // Creates or truncates the file. Throws LogError.
  GameLog(const std::filesystem::path& path, const Field& field,
          std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams);

  // These functions do the same as those of GamePackets.
  void note(Command command) { packets_.note(command); }
  void note(GameEvent event) { packets_.note(std::move(event)); }
  void note(const OtherDetections& others) { packets_.note(others); }

  // Throws LogError.
  void add(const Frame& frame, const RefereeSignal& signal) { packets_.add(frame, signal, *this); }

  // Completes the file. Throws LogError.
  void close() { file_.close(); }

 private:
  void on_vision(double time_s, const VisionPacket& packet) override;
  void on_referee(double time_s, const RefereePacket& packet) override;
  template <typename Message>
  void write(double time_s, MessageKind kind, const Message& message);

  LogWriter file_;
  GamePackets packets_;
  std::string bytes_;
};

}  // namespace autoref::league
