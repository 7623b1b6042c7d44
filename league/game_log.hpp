// Writes a game as an SSL log: the packets of its cameras and its referee.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "league/game_event_message.hpp"
#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "league/messages/vision.pb.h"
#include "league/referee_message.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/game_event.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::league {

// Times count from the game's first frame. Every camera sends one packet per frame, the geometry
// about once a second, and the referee ten packets per second plus one whenever its signal changes.
// Its packets contain the game events since play was on last, or the newest ones if they would
// exceed kLongestPacket.
// The log shows each team at its current end (soccer/published.hpp).
class GameLog {
 public:
  // Creates or truncates the file. Throws LogError.
  GameLog(const std::filesystem::path& path, const Field& field,
          std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams);

  // Notes a command of the next frame. This matters only if one frame has several commands, since
  // the signal contains just the last.
  void note(Command command);

  // Adds an event to the referee's packets from the next frame on. An event without an id gets its
  // number.
  void note(GameEvent event);

  // Notes what the cameras report in addition to the next frame.
  void note(const OtherDetections& others) { others_ = others; }

  // Throws LogError.
  void add(const Frame& frame, const RefereeSignal& signal);

  // Completes the file. Throws LogError.
  void close() { file_.close(); }

 private:
  bool has_changed(const RefereeSignal& signal) const;
  void write_commands_before(const RefereeSignal& signal, double time_s);
  void add_events();
  void write_signal(const RefereeSignal& signal, double time_s);
  template <typename Message>
  void write(double time_s, MessageKind kind, const Message& message);

  LogWriter file_;
  std::vector<CameraPosition> cameras_;
  PerSide<LoggedTeam> teams_;
  VisionPacket geometry_;
  std::vector<VisionPacket> packets_;  // one per camera
  RefereePacket referee_;              // the last one sent
  std::vector<Command> sent_;          // during the current frame
  std::vector<GameEvent> events_;      // since play was on last
  int noted_events_ = 0;
  bool has_new_events_ = false;
  OtherDetections others_;  // in addition to the current frame
  std::string bytes_;
  double geometry_due_s_ = 0;
  double referee_due_s_ = 0;
};

}  // namespace autoref::league
