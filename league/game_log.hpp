// Writes a game as the league's log: what its cameras and its referee send.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "league/log_file.hpp"
#include "league/messages/referee.pb.h"
#include "league/messages/vision.pb.h"
#include "league/referee_message.hpp"
#include "soccer/field.hpp"
#include "soccer/frame.hpp"
#include "soccer/referee_signal.hpp"

namespace autoref::league {

// Times count from the game's first frame. Every camera sends a packet per frame, the geometry
// follows about once a second, the referee sends ten packets a second and one whenever its signal
// changes.
class GameLog {
 public:
  // Starts the file anew. Throws LogError.
  GameLog(const std::filesystem::path& path, const Field& field,
          std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams);

  // A command of the frame that is added next. Only where several are sent in one frame does it
  // tell what the signal does not.
  void note(Command command) { sent_.push_back(command); }

  // Throws LogError.
  void add(const Frame& frame, const RefereeSignal& signal);

  // Completes the file. Throws LogError.
  void close() { file_.close(); }

 private:
  bool has_changed(const RefereeSignal& signal) const;
  void write_commands_before(const RefereeSignal& signal, double time_s);
  void write_signal(const RefereeSignal& signal, double time_s);
  template <typename Message>
  void write(double time_s, MessageKind kind, const Message& message);

  LogWriter file_;
  std::vector<CameraPosition> cameras_;
  PerSide<LoggedTeam> teams_;
  VisionPacket geometry_;
  std::vector<VisionPacket> packets_;  // of each camera
  RefereePacket referee_;              // the last one
  std::vector<Command> sent_;          // in the frame at hand
  std::string bytes_;
  double geometry_due_s_ = 0;
  double referee_due_s_ = 0;
};

}  // namespace autoref::league
