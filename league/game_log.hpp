// Writes a game as an SSL log: the packets of its cameras and its referee.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "league/game_packets.hpp"
#include "league/log_file.hpp"

namespace autoref::league {

// Times count from the game's first frame. The log contains the geometry about once a second, and
// of the referee ten packets per second plus one whenever its signal changes.
class GameLog final : PacketSink {
 public:
  // Creates or truncates the file. Throws LogError.
  GameLog(const std::filesystem::path& path, const Field& field,
          std::vector<CameraPosition> cameras, PerSide<LoggedTeam> teams);

  // As those of GamePackets.
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
