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
  GameLog(const std::filesystem::path& path, const Field& field, std::vector<CameraPlace> cameras,
          PerSide<TeamSheet> teams);

  // Throws LogError.
  void add(const Frame& frame, const RefereeSignal& signal);

  // Completes the file. Throws LogError.
  void close() { file_.close(); }

 private:
  bool has_changed(const RefereeSignal& signal) const;
  template <typename Message>
  void write(double time_s, MessageKind kind, const Message& message);

  LogWriter file_;
  std::vector<CameraPlace> cameras_;
  PerSide<TeamSheet> teams_;
  VisionPacket geometry_;
  std::vector<VisionPacket> pictures_;  // of each camera
  RefereePacket referee_;
  std::string bytes_;
  double geometry_due_s_ = 0;
  double referee_due_s_ = 0;
};

}  // namespace autoref::league
