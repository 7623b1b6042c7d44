// A file with the commands of a game's programs, from which the game can be replayed without them.
//
// A gzip file with a header line, `autoref-commands 1`, and then entries in the order in which they
// took effect. An entry begins with a byte:
//   bits 0-1  0 a change of the world before the teams' next entries, 1 an entry of team a, 2 an
//             entry of team b, 3 the end: 8 bytes with the game's final state follow
//   bit 2     requests follow: keeper and robot that leaves (int8, -1: none), timeout (uint8)
//   bit 3     a fault follows: its length (uint16) and text; the team's last entry
// Unless there is a fault, a uint16 follows: bit n is set if robot n's command differs from its
// previous one, which is initially all zero. Each of these robots then has a byte:
//   bits 0-3  forward, left, angular velocity, kick follow as floats; the others are as before
//   bit 4     chip
//   bit 5     dribble
// In a change of the world, bits 2-3 are 0 for the ball, 1 for a robot that is placed, 2 for one
// that is taken off the field. For a robot, its side (uint8, 0 west) and number (uint8) follow.
// Unless a robot is taken off, these doubles come next: position and velocity, then, for the ball,
// height, vertical speed and 1 if it rolls or 0, or, for a robot, heading (x, y) and angular
// velocity. The first entries may have bits 2-3 equal to 3: they contain the side and number of a
// robot and its limits as doubles, in the order of ChangedRobot. All numbers are little-endian.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "game/team_programs/world_change.hpp"
#include "io/files.hpp"
#include "soccer/robot_command.hpp"

namespace autoref::game {

// The file's information about a team in one step.
struct TeamEntry {
  TeamCommands commands{};  // commands as transmitted() returns them
  TeamRequests requests;
  std::string fault;  // empty unless the team failed; at most 4000 bytes are kept
};

// Whether the commands and requests of both entries are equal.
bool is_same(const TeamEntry& a, const TeamEntry& b);

class CommandsWriter {
 public:
  // The file appears at close(), like every PendingFile. Throws InputOutputError.
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

  // Throws InputOutputError.
  void close(std::uint64_t final_state);

 private:
  void write();
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  io::PendingFile pending_;
  void* file_ = nullptr;  // a gzFile that writes to the file
  std::array<TeamEntry, 2> last_;
  std::string bytes_;
};

class CommandsReader {
 public:
  // Throws InputError if `path` is not a file of commands, and InputOutputError if the file cannot
  // be read.
  explicit CommandsReader(std::filesystem::path path, io::FileKind kind = io::FileKind::kFile);
  ~CommandsReader();
  CommandsReader(const CommandsReader&) = delete;
  CommandsReader& operator=(const CommandsReader&) = delete;

  // Applies the changes made to robots before the game; call this before all other functions.
  // Throws InputError if the file is damaged or `game` does not have these robots.
  void change_robots(GameConfiguration& game);

  // The next entry, which must be an entry of `team`. Throws InputError if it is not, or if the
  // file is damaged or at its end. An entry of another team or an early end means that the file
  // belongs to another game.
  const TeamEntry& next(char team);

  // The next entry if it is a change of the world; nullopt for another entry or the end. Throws
  // InputError if the file is damaged.
  std::optional<WorldChange> next_change();

  // The final state of the game. Throws InputError if the file has further entries.
  std::uint64_t final_state();

 private:
  [[noreturn]] void refuse(const std::string& what) const;
  void read(void* bytes, std::size_t size);
  template <typename Number>
  Number number();
  int robot();  // reads a robot's number; -1: none
  void read_command(RobotCommand& command);
  Vec2 vector();

  std::filesystem::path path_;
  void* file_ = nullptr;  // a gzFile
  std::array<TeamEntry, 2> last_;
};

}  // namespace autoref::game
