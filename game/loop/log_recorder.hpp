// Writes a game as an SSL log while it is played.
#pragma once

#include <filesystem>

#include "game/loop/game_configuration.hpp"
#include "game/loop/observer.hpp"
#include "league/game_packets.hpp"

namespace autoref::game {

// The log has what cameras see and what the referee sends, with the teams' names and the game
// events; it has no commands to robots. All functions throw league::LogError if the file cannot be
// written.
class LogRecorder : public Observer {
 public:
  // Creates or truncates the file, which is compressed if its name ends in .gz.
  LogRecorder(const std::filesystem::path& path, const GameConfiguration& game);

  void on_other_detections(const OtherDetections& others) override;
  void on_frame(const Frame& frame, const RefereeSignal& signal, const sim::World& world) override;
  void on_decision(const referee::Decision& decision) override;

  // Completes the file; without this, its end may be missing.
  void close() { log_.close(); }

 private:
  league::GameLog log_;
};

}  // namespace autoref::game
