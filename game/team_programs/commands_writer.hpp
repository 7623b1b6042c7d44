// Writes a file of commands (commands_file.hpp).
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>

#include "game/team_programs/commands_file.hpp"
#include "game/team_programs/world_change.hpp"
#include "io/files.hpp"

namespace autoref::game {

class CommandsWriter {
 public:
  // The file appears at close(), like every PendingFile. If it is a growing file, what was added
  // more than a second before the last addition has been written. Throws InputOutputError.
  explicit CommandsWriter(const std::filesystem::path& path,
                          io::FileKind kind = io::FileKind::kFile);
  ~CommandsWriter();
  CommandsWriter(const CommandsWriter&) = delete;
  CommandsWriter& operator=(const CommandsWriter&) = delete;

  // `team` is 'a' or 'b'. Throws InputOutputError.
  void add(char team, const TeamEntry& entry);

  // Adds a robot that was changed before the game; call this before all other functions. Throws
  // InputOutputError.
  void add(const ChangedRobot& changed);

  // Adds a change before the next step. Throws InputOutputError.
  void add(const WorldChange& change);

  // `is_interrupted`: whether the game was interrupted in this state. Throws InputOutputError.
  void close(std::uint64_t final_state, bool is_interrupted = false);

 private:
  using Clock = std::chrono::steady_clock;

  void open();
  void write();
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  io::FileKind kind_;
  io::PendingFile pending_;
  Clock::time_point flushed_{};  // long ago
  void* file_ = nullptr;         // a gzFile that writes to the file
  std::array<TeamEntry, 2> last_;
  std::string bytes_;
};

}  // namespace autoref::game
